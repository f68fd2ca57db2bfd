// Mass, centroid and inertia of a body of constant density rho:
//
//   m = int rho,   c = int rho x / m,   J = int rho (|x - c|^2 1 - (x - c)(x - c)^T)
//
// in closed form: box m (b^2 + c^2)/12, cylinder m (3R^2 + h^2)/12 and m R^2/2, sphere 2 m R^2/5, superquadrics by
// their moments (superquadric.h).
#pragma once

#include <string_view>

#include "mechanics/geometry/shape.h"
#include "mechanics/types.h"

namespace mb {

struct MassProperties {
  double mass;              // [kg] > 0
  Vector3d centroid;        // [m] body frame
  Eigen::Matrix3d inertia;  // [kg m^2] about the centroid, body axes; symmetric
};

// density [kg/m^3] > 0. Throws std::invalid_argument where it or a size of the shape is not positive and finite.
MassProperties mass_properties(const Shape& shape, double density);

// J = axes diag(moments) axes^T: X = axes X_principal in body axes. The principal axes are those next to the body's, in
// their order: a diagonal J has the identity.
struct PrincipalAxes {
  Vector3d moments;         // [kg m^2] > 0, the largest at most the sum of the others
  Eigen::Quaterniond axes;  // [-] of unit length
};

// By Jacobi rotations. Throws std::invalid_argument where J is no inertia tensor: not symmetric (relative 1e-12), or
// its moments are not those of a body.
PrincipalAxes principal_axes(const Eigen::Matrix3d& inertia);

// Throws std::invalid_argument, naming `where`, unless the moments are positive (the least above 1e-100 of the
// largest), finite and satisfy the triangle inequality, which flat bodies meet with equality (relative 1e-12 allowed
// for rounding).
void require_principal_moments(const Vector3d& moments, std::string_view where);

}  // namespace mb
