// Newmark's average acceleration (beta 1/4, gamma 1/2): unconditionally stable, second order, no numerical damping.
//
//   (4/h^2 M + 2/h C + K) u+ = F s+ + M (4/h^2 u + 4/h v + a) + C (2/h u + v)
//   v+ = 2/h (u+ - u) - v,   a+ = 4/h^2 (u+ - u) - 4/h v - a
//
// One factor for the whole run; one more, of M, where it starts loaded. Newmark 1959, J. Eng. Mech. Div. ASCE 85(3).
#pragma once

#include <memory>

#include "mechanics/system/system.h"

namespace mb {

// h [s] > 0. Output times between steps are read off the cubic Hermite polynomial of (u, v) at both ends.
// The system must outlive the stepper.
std::unique_ptr<Stepper> newmark(const System& system, double h);

}  // namespace mb
