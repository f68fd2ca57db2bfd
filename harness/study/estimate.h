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
//   map of stability          8 s, of contact 40 s                  4 to 15 s and 35 to 55 s were seen
//
// n degrees of freedom, elements of degree p; f of them stand in the narrowest layer across the mesh, what a factor's
// rows are about as wide as: few where it is slender. The constants fit the cases without contact on two cores of an
// AMD EPYC server (2026) within a factor of two, truths of those with it within four; another machine or load moves
// them by about twice.
#pragma once

#include "harness/catalogue.h"
#include "harness/study/plan.h"

namespace mb {

struct Estimate {
  double truth, contenders, analyses;  // [s] on two cores, nothing stored yet
  double total() const { return truth + contenders + analyses; }
};
Estimate estimate(const Scene& scene, const Catalogue& catalogue);

// [byte] of memory at the peak, likewise before anything is allocated:
//
//   a mesh      n (300 (p + 2)^3 + 35 f) B    matrices and what they are made of; factors. 70 f where
//                                             faces may touch: responses to their forces beside them
//   r modes     8 n (7 r + 400) B             Lanczos vectors and their images, the modes, what the gate makes of them
//   all modes   72 n^2 B                      a dense solver: of more than a third of all, or the closed form of `full`
//   states      32 k B a sample               of k unknowns: u, v and theirs in modes; a frame, where it is timed
//   answers     8 B (3 points + 6 strained points) samples of each body; and 256 MiB
//   complex     960 k^2 B                     of k modes coupled by a dashpot, in closed form
//   marks       5 answers, and 12 an analysis: frames, weights and spectra beside them
//   truths      5 answers, and the dearest mesh of those to compute and the next, two at a time, or their marks
//
// Measured: what a run takes at its peak grows by a quarter to all of this (memory_peak_test.cc). Modes: counted, as
// allocated at once.
double memory(const Scene& scene);  // of the truths, none of them stored
double memory_of_truths(const Scene& scene, const std::vector<Resolution>& meshes);  // those read, but on these meshes
double memory_of_answers(const Scene& scene);                                  // theirs alone, once they are there
double memory(const Scene& scene, const Resolution& mesh);                     // of one mesh and one answer
double memory(const Scene& scene, const Contender& contender, bool timed);     // that, with its modes and states
double memory_of_modes(const Scene& scene, const Body& body, double n_modes);  // of one body's mesh, and modes of it
double memory_of_analysis(const Scene& scene, const Resolution& mesh);  // of one more mesh and the study's most modes
// Likewise of a contender's marks; or of an analysis, on the case's own meshes with the largest mode count of the study
// and with every truth once more. Other meshes that it makes are asked for by memory_of_analysis when it makes them.
double memory(const Scene& scene, const Job& job, bool timed);

}  // namespace mb
