// One body against one rigid obstacle or another body, as the unknowns of their meshes see it:
//
//   x_i = X_i + (U u)_i,   f = sum_i w_i U_i^T t(gap(x_i), v_i),   v_i = (U u')_i
//
// Against another body the gap is that of its deformed boundary, v_i relative to the foot S of x_i on it
// (facets.h), and its nodes feel -N_a t: forces sum to zero, and torques, about current positions, but for the gap
// times the friction. Linear kinematics: frames stand still, and everything is in the axes of one of them.
#pragma once

#include <memory>

#include "mechanics/contact/facets.h"
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
  RigidSurface surface;  // in the same axes; not looked at where there is a partner
  PenaltyLaw law;
  ContactScale scale;
  bool meets = true;  // the surfaces, at the start; points between may press a little later
  std::shared_ptr<const Facets> partner = nullptr;  // of another body; none: an obstacle
};

}  // namespace mb
