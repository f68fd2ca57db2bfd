// A neo-Hookean body (mechanics/material/neo_hookean.h) on the mesh, total Lagrangian:
//
//   F = 1 + sum_a u_a (x) d_N_a,   W = int W(F),   f_a = int (P + P_v) d_N_a
//   K_ab = int lambda g_a (x) g_b + (mu - lambda ln J) g_b (x) g_a + mu (d_N_a . d_N_b) 1,     g_a = G^T d_N_a
//   D_ab = beta int lambda h_a (x) h_b + mu h_b (x) h_a + mu (d_N_a . d_N_b) F F^T,            h_a = F d_N_a
//
// by the quadrature of K (assembly.h), so that K_T(0) = K to rounding; of D's derivative by u nothing is in K_T. Values
// of d_N at quadrature points are kept: 72 n^2 bytes a cell with n = (degree + 1)^3, at degree 4 1.1 MB. Supports and
// hanging nodes are condensed, cell by cell: f = T^T f_full, K = T^T K_full T, in the pattern of the linear K.
#pragma once

#include <vector>

#include "mechanics/material/neo_hookean.h"
#include "mechanics/system/stored_energy.h"
#include "reference/fem/supports.h"

namespace mb::fem {

class FiniteStrain final : public StoredEnergy {
 public:
  // system: M, K and R of this mesh, its beta. Throws std::invalid_argument for a material that is not isotropic.
  FiniteStrain(const Discretisation& d, const Supports& supports, const Material& material, const System& system);

  double energy(const VectorXd& u) const override;
  bool force(const VectorXd& u, const VectorXd& v, VectorXd& f) const override;
  bool add_tangent(const VectorXd& u, double by_u, double by_v, SparseMatrix& A) const override;
  std::vector<Turn> turns(const VectorXd& u) const override;
  MatrixXd rigid_motions(const VectorXd& u) const override;

 private:
  // Of the unknowns that a cell's nodes follow, `unknowns`: which of them entry 3 a + i is (-1: held), or, where
  // weights are, T's rows; and where each pair stands in the values of K.
  struct Condensed {
    std::vector<int> place;   // 3 n, or empty
    MatrixXd T;               // 3 n x m, or empty
    std::vector<int> values;  // m x m
    Index m;
  };
  struct Cell {
    std::vector<Index> nodes;  // n
    MatrixXd gradients;        // [1/m] n x 3 q: d_0 N at all points, then d_1 N, d_2 N
    VectorXd w;                // [m^3] q
    MatrixXd laplacian;        // [m] n x n, int d_N_a . d_N_b
    Condensed to;
  };
  struct Scratch;
  void condense(Cell& cell, const Eigen::SparseMatrix<double, Eigen::RowMajor>& T, const SparseMatrix& K) const;
  VectorXd at_nodes(const VectorXd& u) const;  // T u
  bool evaluate(const Cell& cell, const VectorXd& nodal, double by_u, double viscous, Scratch& s) const;
  bool tangent_of(const Cell& cell, const VectorXd& nodal, double by_u, double by_v, Scratch& s) const;
  static void add(const Cell& cell, Scratch& s, SparseMatrix& A);

  Lame c_;
  double beta_;
  SparseMatrix T_;
  bool all_free_;            // T is the identity
  std::vector<Index> kept_;  // n
  Matrix3Xd X_;              // [m] of all nodes
  Vector3d centroid_;
  MatrixXd twists_;     // 6 x m: translation and rotation about the centroid of every column of R
  MatrixXd mass_by_X_;  // n/3 x 3, rho int N_a (X - X_c); of a body without supports
  std::vector<Cell> cells_;
};

}  // namespace mb::fem
