// Matrices of linear elasticity on all nodes, supports not yet applied:
//
//   M_(3a+i)(3b+i) = int rho N_a N_b,   K_(3a+i)(3b+j) = sum_kl C_ikjl int d_k N_a d_l N_b,   F = int_patch w t N_a
//
// Full Gauss quadrature with p + 1 points a direction.
#pragma once

#include "reference/fem/discretisation.h"

namespace mb::fem {

struct Matrices {
  SparseMatrix M, K;   // [kg], [N/m], full storage
  double mesh_volume;  // [m^3]
};
Matrices assemble(const Discretisation& d, const Material& material);

// int_patch w(x) N_a n_i dA as a vector of size n_dofs (n: outward normal; direction absent), or int_patch w N_a t_i dA
// for a fixed vector t; discs on the exact face, whole faces on the mesh's. Throws std::invalid_argument for a disc off
// its face.
VectorXd patch_load(const Discretisation& d, const Patch& patch, const Vector3d& traction);
VectorXd patch_normal(const Discretisation& d, const Patch& patch);

}  // namespace mb::fem
