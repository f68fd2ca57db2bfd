// One body against one rigid obstacle, as the unknowns of a mesh see it:
//
//   x_i = X_i + (U u)_i,   f = sum_i w_i U_i^T t(gap(x_i), v_i),   v_i = (U u')_i
//
// Linear kinematics: the body's frame stands still, and everything is in its axes.
#pragma once

#include "mechanics/contact/law.h"

namespace mb {

struct ContactPoints {
  Matrix3Xd X;     // [m] 3 x m, quadrature points of the body's surface at rest
  VectorXd w;      // [m^2] m, > 0
  SparseMatrix U;  // 3 m x n: xyz of point 0, of point 1, ...
};

// Sizes that an impact reaches, by which errors are judged: both > 0.
struct ContactScale {
  double displacement, velocity; /* [m], [m/s] */
};

struct Contact {
  ContactPoints points;
  RigidSurface surface;  // in the body's axes
  PenaltyLaw law;
  ContactScale scale;
  bool meets = true;  // the surfaces, at the start; points between may press a little later
};

}  // namespace mb
