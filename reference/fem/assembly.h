// Matrices of linear elasticity on all nodes, supports not yet applied:
//
//   M_(3a+i)(3b+i) = int rho N_a N_b,   K_(3a+i)(3b+j) = sum_kl C_ikjl int d_k N_a d_l N_b,   F = int_patch w t N_a
//
// Full Gauss quadrature with p + 1 points a direction. The lumped mass takes Gauss and Lobatto's rule instead, whose
// points are the nodes:
//
//   m_a = w_a rho |J(x_a)|, summed over the cells at node a
//
// Fried & Malkus 1975, Int. J. Solids Structures 11(4).
#pragma once

#include "reference/fem/discretisation.h"

namespace mb::fem {

struct Matrices {
  SparseMatrix M, K;   // [kg], [N/m], full storage
  double mesh_volume;  // [m^3]
};
Matrices assemble(const Discretisation& d, const Material& material);
double mesh_volume(const Discretisation& d);  // [m^3]

// [kg] n_dofs, all > 0; in each direction they sum to the mass, on the coarsest balls to that quadrature's error alone
// (0.13, 0.003, 6e-4, 2e-5 of it for degree 1 to 4 on seven blocks). Throws std::invalid_argument naming the node where
// it is not.
VectorXd lumped_mass(const Discretisation& d, double density);  // density [kg/m^3]

// int_patch w (t - p n)_i N_a dA as a vector of size n_dofs, n the outward normal; and int_patch w n_i N_a dA. Discs
// are integrated on the exact face, with its normal; whole faces on the mesh's, so that a uniform pressure all over a
// body is in balance to rounding. traction t, pressure p [Pa]. Throws std::invalid_argument for a disc off its face.
// Points of a disc are a quarter as far apart as the mesh's nodes there on average, with 128 rings at most (DiscRule):
// beyond 32 nodes to the radius the load is one at points again.
VectorXd patch_load(const Discretisation& d, const Patch& patch, const Vector3d& traction, double pressure = 0);
VectorXd patch_normal(const Discretisation& d, const Patch& patch);

}  // namespace mb::fem
