// Observation of a finite-element field at given points:
//
//   u(x) = sum_a N_a(xi) u_a,   x = x_mapped(xi) in the nearest cell, the lowest index on ties
#pragma once

#include "reference/fem/discretisation.h"

namespace mb::fem {

// points [m]: 3 x p, inside the shape or on its surface (the mesh may miss them by its boundary error).
// 3 p x n_dofs; throws std::invalid_argument for a point in no cell's reach.
SparseMatrix displacement_at(const Discretisation& d, const Matrix3Xd& points);
// Loads of forces [N] (3 x p) at such points: displacement_at(d, points)^T forces, without the matrix.
VectorXd nodal_loads(const Discretisation& d, const Matrix3Xd& points, const Matrix3Xd& forces);
SparseMatrix strain_at(const Discretisation& d, const Matrix3Xd& points);  // 6 p x n_dofs, Voigt, engineering shear

}  // namespace mb::fem
