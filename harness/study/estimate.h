// How long a case will take, before anything is computed: counts of operations times constants measured once.
//
//   newmark step              s = n (0.66 (p + 2)^3 + 0.3 f) ns     one solve, two products with the matrices
//   explicit step             s/3                                   one product
//   step of finite strain     12 s                                  a stage iterates, each time with factors of its own
//   adaptive steps            4 rtol^-0.3, 30 s each                6 times as many after a jump, twice with stiffness
//                                                                   damping
//   assembly, factor          0.2 ms n/p
//   r modes                   (70 + r) 9 s                          with the gate that checks them
//   dense spectrum            2 ns n^3                              closed form of a mesh of n degrees of freedom
//
// n degrees of freedom, elements of degree p; f of them stand in the narrowest layer across the mesh, what a factor's
// rows are about as wide as: few where it is slender. The constants fit the cases without contact on two cores of an
// AMD EPYC server (2026) within a factor of two, truths of those with it within four; another machine or load moves
// them by about twice.
#pragma once

#include "harness/catalogue.h"

namespace mb {

struct Estimate {
  double truth, contenders, analyses;  // [s] on two cores, nothing stored yet
  double total() const { return truth + contenders + analyses; }
};
Estimate estimate(const Scene& scene, const Catalogue& catalogue);

// [byte] of memory at the peak, likewise before anything is allocated:
//
//   a mesh      n (300 (p + 2)^3 + 25 f) B    matrices and what they are made of; factors
//   two truths  the dearest mesh and the next, computed at a time
//   answers     5 truths, 8 B (3 points + 6 strained points) samples of each body; and 256 MiB
//
// Within a third of what cylinders of 7,500 to 67,000 degrees of freedom took, p = 2 to 4.
double memory(const Scene& scene);
double memory(const Scene& scene, const Resolution& mesh);  // of one mesh and one answer

}  // namespace mb
