// Smooth ordinary differential equations y' = f(t, y), by extrapolation to a step of zero:
//
//   S(h/n): n steps of the modified midpoint rule over h, n = 2, 4, ... 16, errs in even powers of h/n only;
//   T_j,k = T_j,k-1 + (T_j,k-1 - T_j-1,k-1) / ((n_j / n_j-k)^2 - 1)
//
// Up to order 16, the step chosen so that |T_jj - T_j,j-1| meets the tolerance. Gragg 1965, SIAM J. Numer. Anal. 2;
// Bulirsch & Stoer 1966, Numer. Math. 8; Hairer, Norsett & Wanner 1993, Solving Ordinary Differential Equations I,
// sect. II.9. Equations should be analytic along the way: choose variables in which they are.
#pragma once

#include <functional>

#include "mechanics/types.h"

namespace mb {

using Derivative = std::function<VectorXd(double t, const VectorXd& y)>;

struct OdeState {
  double t;
  VectorXd y;
};
// Of each component over one step: at most absolute + relative |y|.
struct OdeTolerance {
  double relative = 1e-13;  // [-] >= 1e-15
  double absolute = 1e-17;  // in the units of y, >= 0
};

// From start to t_end, forwards or backwards.
OdeState integrate(const Derivative& f, const OdeState& start, double t_end, const OdeTolerance& tolerance = {});

// From start forwards until y[component], positive after the first step, falls through zero: there, to rounding, by
// Newton's method on the step within the bracket. The crossing must be transversal.
OdeState integrate_to_zero(const Derivative& f, const OdeState& start, Index component,
                           const OdeTolerance& tolerance = {});

// Both throw std::invalid_argument for a start, end or tolerance out of range, and std::runtime_error, naming the time,
// where no step however small meets the tolerance or a million of them do not suffice.

}  // namespace mb
