// The elastic modes of a body as polynomials, by which contact sees them: phi_k(X) = sum_j a_jk m_j(X), of the least
// degree that is nearly as good as any up to 8,
//
//   residual_k(degree) <= 2 residual_k(8) + 3e-4   for every mode k
//
// Of the whole body: what carries its surface in flight and its own samples. Near a point: what a partner meets of it.
// A slender body's modes have more waves along it than a polynomial; over the size of what it meets they have few.
#pragma once

#include "cases/contract/model.h"
#include "mechanics/geometry/polynomial_regression.h"
#include "modal/frame/floating_body.h"

namespace mb {

// Phi_at_points: 3 p x r, the modes at mesh.points.all(); fitted there, inside and surface by about half the weight.
Regression polynomials_of(const BodyModel& mesh, const MatrixXd& Phi_at_points);

// Within reach [m] of the point X [m] of the surface along each axis, and in the body; Phi n x r of the mesh.
Regression polynomials_near(const Shape& shape, const FullModel& full, const MatrixXd& Phi, const Vector3d& X,
                            double reach);

// A partner's surface: body, its place; geometry of polynomials_near, or of the whole body; Psi [m] 3 m x n_s at the
// feet [m] 3 x m, both in its frame (floating_body.h).
PartnerSurface partner_surface(size_t body, const Shape& shape, PolynomialBasis geometry, Matrix3Xd feet,
                               const MatrixXd& Psi);

}  // namespace mb
