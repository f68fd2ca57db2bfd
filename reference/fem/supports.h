// Supports as a linear map from free to all degrees of freedom:
//
//   u_full = T u,   fixed and sliding drop columns; a zero area mean c^T u_full = 0 expresses one entry by the others
#pragma once

#include "reference/fem/discretisation.h"

namespace mb::fem {

struct Supports {
  SparseMatrix T;           // n_dofs x n_free
  std::vector<Index> kept;  // n_free ascending: u_i = u_full[kept_i]
};
// Throws std::invalid_argument if nothing stays free.
Supports condense(const Discretisation& d, const std::vector<Support>& supports);

// Rigid motions which T leaves free, n_free x m, orthonormal in M (n_free x n_free): translations and rotations about
// the centroid, of which those that violate a support (relative 1e-10) are removed.
MatrixXd free_rigid_modes(const Discretisation& d, const Supports& supports, const SparseMatrix& M);

}  // namespace mb::fem
