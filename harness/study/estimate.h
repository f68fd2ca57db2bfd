// How long a case will take, before anything is computed: counts of operations times constants measured once.
//
//   newmark step      s(n) = 9 ms (n/17,187)^1.6              one solve, two products with the matrices
//   explicit step     s(n)/3                                  one product
//   adaptive steps    4 rtol^-0.3, 35 s(n) each               eight times as many after a sudden load
//   assembly, factor  0.3 ms n/p                              n degrees of freedom, elements of degree p
//   r modes           (70 + r) 10 ms (n/4,539)^1.3            with the gate that checks them
//   dense spectrum    2 ns n^3                                closed form of a mesh of n degrees of freedom
//
// The constants fit runs of the contact-free cases on two cores of an AMD EPYC server (2026) within a factor of two;
// another machine or load moves them by about as much again; a slender mesh (rod-step) takes a tenth.
#pragma once

#include "harness/catalogue.h"

namespace mb {

struct Estimate {
  double truth, contenders, analyses;  // [s] on two cores, nothing stored yet
  double total() const { return truth + contenders + analyses; }
};
Estimate estimate(const Scene& scene, const Catalogue& catalogue);

}  // namespace mb
