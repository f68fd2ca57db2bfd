// The rigid frame (c, R) in which a moved body looks least deformed, and what is left of its motion there:
//
//   minimise  sum_i w_i |x_i - c - R (X_i - X_c)|^2,   x = X + u,   X_c = sum w X / sum w
//   c = sum w x / sum w,   R = U diag(1, 1, det U V^T) V^T,   sum_i w_i (x_i - c)(X_i - X_c)^T = U S V^T
//   deformation  d_i = R^T (x_i - c) - (X_i - X_c)
//
// Kabsch 1976, Acta Cryst. A32; Umeyama 1991, IEEE Trans. PAMI 13(4) for the determinant. At constant density the
// density cancels.
#pragma once

#include <vector>

#include "mechanics/types.h"

namespace mb {

struct RigidFrame {
  Vector3d c;         // [m] where the body's centroid is
  Eigen::Matrix3d R;  // [-] rotation, det R = +1
};

// u: 3 n displacements [m] (xyz of point 0, of point 1, ...) of the points X with weights w > 0. NaN where u is not
// finite. Fewer than three points off a line leave the rotation to rounding.
RigidFrame rigid_frame(const Matrix3Xd& X, const VectorXd& w, const VectorXd& u);

// d [m] of the points X, 3 n, in a frame fitted to a body whose centroid was X_c.
VectorXd deformation(const RigidFrame& frame, const Vector3d& X_c, const Matrix3Xd& X, const VectorXd& u);

Vector3d centroid(const Matrix3Xd& X, const VectorXd& w);  // [m]

// Angle in [0, pi] of R^T S. From |R - S|_F = 2 sqrt(2) sin(angle/2): exact for small angles too.
double angle_between(const Eigen::Matrix3d& R, const Eigen::Matrix3d& S);

}  // namespace mb
