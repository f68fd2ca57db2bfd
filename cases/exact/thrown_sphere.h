// The closed form `hertz-impact`: an elastic sphere, thrown or dropped without spin on a rigid plane, by the
// quasi-static law of sphere_impact.h: Hertz's, corrected for the finite sphere and the layer; of the contact alone.
//
// How far it holds, with T the duration, T_1 = 2.375 R/c_t about the longest period (of the mode S2, Lamb 1882) and
// a/R, k_n those of Hertz's impact, as parts of the peak force and of the duration:
//
//   waves                5 (pi T_1/(2 pi T))^4 = 0.3 (T_1/T)^4         mode S2's share of the approach, its inertia
//   layer                (E*/(k_n a))^2                                second order of its compliance
//
// T >= 6 T_1 and k_n a/E* >= 50 keep either below 4e-4.
#pragma once

#include "cases/exact/exact.h"

namespace mb {

ExactSolution thrown_sphere();

}  // namespace mb
