// How a stress turns forces when displacements turn it (initial stress, geometric stiffness):
//
//   G_(3a+i)(3b+j) = delta_ij int d_k N_a sigma_kl d_l N_b,     sigma = C : eps(u)
//
// symmetric, linear in u; v^T G v / 2 is the work of sigma on the second-order strain of v, grad v^T grad v / 2.
#pragma once

#include "mechanics/material/elasticity.h"
#include "reference/fem/discretisation.h"

namespace mb::fem {

// u [m] n_dofs at all nodes; [N/m] n_dofs x n_dofs. By the quadrature of K (assembly.h).
SparseMatrix stress_stiffness(const Discretisation& d, const Material& material, const VectorXd& u);

}  // namespace mb::fem
