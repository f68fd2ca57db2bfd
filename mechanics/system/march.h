// Equal steps t_i = i h from t = 0; what lies between them is read off the cubic Hermite polynomial of both ends:
//
//   u(t_i + x h) = (1 + 2x)(1 - x)^2 u_i + x (1 - x)^2 h v_i + x^2 (3 - 2x) u_{i+1} - x^2 (1 - x) h v_{i+1}
// Steps do not end where a load jumps: unless a multiple of h falls there, the load comes up to h late or early, and
// every scheme is of first order.
#pragma once

#include <functional>

#include "mechanics/system/system.h"

namespace mb {

struct Motion {
  VectorXd u, v;  // [m], [m/s]
};

// From t0 to t1 = t0 + h: writes `to`, which has its size. May keep more of its own between calls.
using FixedStep = std::function<void(double t0, double t1, const Motion& from, Motion& to)>;

// States at times [s], ascending, first >= 0, finite; else throws std::invalid_argument. h [s] > 0. A run that grows
// beyond what is finite stops as not_finite within 64 steps. Of the work, steps is counted: one load evaluation each.
States march(const System& system, double h, const VectorXd& times, const FixedStep& step);

// h, where it is positive and finite; else throws std::invalid_argument that names the integrator.
double checked_step(double h, const char* integrator);

}  // namespace mb
