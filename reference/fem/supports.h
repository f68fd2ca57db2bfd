// Supports as a linear map from free to all degrees of freedom:
//
//   u_full = T u,   fixed, driven, sliding and diaphragm drop columns; a zero area mean c^T u_full = 0 expresses one
//                   entry by the others; so do hanging nodes, each by its masters (grading.h)
//
// Where a base drives the body, u is the displacement relative to it, of every support of the body: they all ride on
// that base, which moves as a rigid whole by r b(t), r = direction at every node. K r = 0, so that it acts by inertia,
//
//   M u'' + C u' + K u = F s - T^T M_full r b''
#pragma once

#include "reference/fem/discretisation.h"

namespace mb::fem {

struct Supports {
  SparseMatrix T;           // n_dofs x n_free; the identity where nothing is held and nothing hangs
  std::vector<Index> kept;  // n_free ascending, of nodes that do not hang: u_i = u_full[kept_i]
};
// Means are of the mesh's face: where a disc is graded on one side, its centroid is off by the boundary error, and the
// means of both ends of a cylinder hold a tilt, too. Throws std::invalid_argument if nothing stays free, and for
// sliding and diaphragm supports on curved faces.
Supports condense(const Discretisation& d, const std::vector<Support>& supports);

// The drive of the driven supports, none without such. Throws std::invalid_argument where one of them states no drive
// or another than the rest, a direction is not of unit length, or a support of another kind states one.
std::optional<Drive> common_drive(const std::vector<Support>& supports);
VectorXd translation(const Discretisation& d, const Vector3d& direction);  // r above, n_dofs

// Polynomials of at most that degree (>= 0, else std::invalid_argument) for each component, in the combinations that
// every support admits (relative 1e-10): n_free x k of full rank, orthonormal as values at all nodes. Where the mesh
// has fewer nodes than there are monomials, as many as it tells apart. Polynomials are those of the nodes that do not
// hang; the others follow.
MatrixXd polynomials(const Discretisation& d, const Supports& supports, int degree);

// Rigid motions which T leaves free, n_free x m, orthonormal in M (n_free x n_free): translations and rotations about
// the centroid, of which those that violate a support (relative 1e-10) are removed.
MatrixXd free_rigid_modes(const Discretisation& d, const Supports& supports, const SparseMatrix& M);

}  // namespace mb::fem
