// For tests: a homogeneous isotropic box on a uniform grid of hexahedra of degree 1 or 2, full quadrature, consistent
// mass. On such a grid every integral is a product of three integrals along the axes (Kronecker products):
//
//   K_ab = lambda int d_a N_i d_b N_j + mu int d_b N_i d_a N_j + delta_ab mu sum_c int d_c N_i d_c N_j
#pragma once

#include <array>
#include <functional>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/system.h"

namespace mb::testing {

struct BoxMesh {
  std::array<int, 3> cells;
  int degree = 1;
  Vector3d size = {1, 1, 1};                                         // [m], from the origin to size
  double E = 1, nu = 0.3, rho = 1;                                   // [Pa], [-], [kg/m^3]
  std::function<bool(const Vector3d& x, int component)> fixed = {};  // degrees of freedom to remove, none if empty
};

struct BoxSystem {
  System system;
  Matrix3Xd nodes;         // [m]
  std::vector<Index> dof;  // 3 a node: index of its free degree of freedom, or -1
};

// int N_i N_j, int N_i' N_j, int N_i' N_j' along one axis.
struct AxisMatrices {
  MatrixXd mass, mixed, stiffness;
};
inline AxisMatrices axis_matrices(int cells, int degree, double length) {
  const double h = length / cells;
  MatrixXd m(degree + 1, degree + 1), d(degree + 1, degree + 1), k(degree + 1, degree + 1);
  if (degree == 1) {
    m << 2, 1, 1, 2;
    d << -1, -1, 1, 1;
    k << 1, -1, -1, 1;
    m *= h / 6, d *= 1. / 2, k *= 1 / h;
  } else if (degree == 2) {
    m << 4, 2, -1, 2, 16, 2, -1, 2, 4;
    d << -3, -4, 1, 4, 0, -4, -1, 4, 3;
    k << 7, -8, 1, -8, 16, -8, 1, -8, 7;
    m *= h / 30, d *= 1. / 6, k *= 1 / (3 * h);
  } else {
    throw std::invalid_argument("box of degree 1 or 2");
  }
  const Index n = cells * degree + 1;
  AxisMatrices axis{MatrixXd::Zero(n, n), MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)};
  for (Index first = 0; first + degree < n; first += degree) {
    axis.mass.block(first, first, degree + 1, degree + 1) += m;
    axis.mixed.block(first, first, degree + 1, degree + 1) += d;
    axis.stiffness.block(first, first, degree + 1, degree + 1) += k;
  }
  return axis;
}

// M-orthonormal rigid motions that move no removed degree of freedom.
inline MatrixXd rigid_modes(const BoxSystem& box, const Vector3d& centre) {
  const Index n_nodes = box.nodes.cols();
  MatrixXd motion(3 * n_nodes, 6);
  for (Index node = 0; node < n_nodes; ++node)
    for (int axis = 0; axis < 3; ++axis) {
      motion.block<3, 1>(3 * node, axis) = Vector3d::Unit(axis);
      motion.block<3, 1>(3 * node, 3 + axis) = Vector3d::Unit(axis).cross(box.nodes.col(node) - centre);
    }
  MatrixXd free(box.system.M.rows(), 6);
  MatrixXd removed = MatrixXd::Zero(motion.rows(), 6);
  for (Index i = 0; i < motion.rows(); ++i) (box.dof[i] < 0 ? removed.row(i) : free.row(box.dof[i])) = motion.row(i);
  const EigenPairs of = symmetric_eigen(removed.transpose() * removed);
  const Index m = (of.values.array() < 1e-12 * motion.squaredNorm()).count();
  const MatrixXd R = free * of.vectors.leftCols(m);
  const MatrixXd gram = R.transpose() * (box.system.M * R);
  return gram.llt().matrixU().solve<Eigen::OnTheRight>(R);
}

// Nodes numbered along x, then y, then z.
struct Grid {
  std::array<AxisMatrices, 3> axis;
  std::array<Index, 3> n;  // nodes along each axis

  explicit Grid(const BoxMesh& box) {
    for (size_t a = 0; a < 3; ++a) {
      axis[a] = axis_matrices(box.cells[a], box.degree, box.size[static_cast<Index>(a)]);
      n[a] = axis[a].mass.rows();
    }
  }
  Index size() const { return n[0] * n[1] * n[2]; }
  std::array<Index, 3> at(Index node) const { return {node % n[0], node / n[0] % n[1], node / n[0] / n[1]}; }

  // int d_p N_i d_q N_j; p = -1, q = -1: no derivative.
  double integral(Index i, Index j, int p, int q) const {
    const auto from = at(i), to = at(j);
    double product = 1;
    for (int c = 0; c < 3; ++c) {
      const auto& matrices = axis[static_cast<size_t>(c)];
      const Index k = from[static_cast<size_t>(c)], l = to[static_cast<size_t>(c)];
      product *= c == p ? (c == q ? matrices.stiffness(k, l) : matrices.mixed(k, l))
                        : (c == q ? matrices.mixed(l, k) : matrices.mass(k, l));
    }
    return product;
  }
  // Nodes within `reach` of node i along every axis: all that share a cell with it.
  std::vector<Index> neighbours(Index i, Index reach) const {
    std::vector<Index> found;
    const auto c = at(i);
    for (Index z = std::max<Index>(0, c[2] - reach); z <= std::min(n[2] - 1, c[2] + reach); ++z)
      for (Index y = std::max<Index>(0, c[1] - reach); y <= std::min(n[1] - 1, c[1] + reach); ++y)
        for (Index x = std::max<Index>(0, c[0] - reach); x <= std::min(n[0] - 1, c[0] + reach); ++x)
          found.push_back(x + n[0] * (y + n[1] * z));
    return found;
  }
};

inline BoxSystem numbered(const Grid& grid, const BoxMesh& box) {  // nodes and free degrees of freedom
  BoxSystem result;
  result.nodes.resize(3, grid.size());
  Index n_free = 0;
  for (Index node = 0; node < grid.size(); ++node) {
    const auto at = grid.at(node);
    for (size_t a = 0; a < 3; ++a)
      result.nodes(static_cast<Index>(a), node) =
          box.size[static_cast<Index>(a)] * static_cast<double>(at[a]) / static_cast<double>(grid.n[a] - 1);
    for (int a = 0; a < 3; ++a) result.dof.push_back(box.fixed && box.fixed(result.nodes.col(node), a) ? -1 : n_free++);
  }
  result.system.M.resize(n_free, n_free);
  result.system.K.resize(n_free, n_free);
  return result;
}

inline BoxSystem box_system(const BoxMesh& box) {
  const Grid grid(box);
  BoxSystem result = numbered(grid, box);
  const double mu = box.E / (2 * (1 + box.nu)), lambda = 2 * mu * box.nu / (1 - 2 * box.nu);
  std::vector<Eigen::Triplet<double>> M, K;
  for (Index i = 0; i < grid.size(); ++i)
    for (const Index j : grid.neighbours(i, box.degree)) {
      const double mass = box.rho * grid.integral(i, j, -1, -1);
      const double laplace = mu * (grid.integral(i, j, 0, 0) + grid.integral(i, j, 1, 1) + grid.integral(i, j, 2, 2));
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          const Index row = result.dof[static_cast<size_t>(3 * i + a)];
          const Index column = result.dof[static_cast<size_t>(3 * j + b)];
          if (row < 0 || column < 0) continue;
          K.emplace_back(row, column,
                         lambda * grid.integral(i, j, a, b) + mu * grid.integral(i, j, b, a) + (a == b ? laplace : 0));
          if (a == b) M.emplace_back(row, column, mass);
        }
    }
  System& system = result.system;
  system.M.setFromTriplets(M.begin(), M.end());
  system.K.setFromTriplets(K.begin(), K.end());
  system.R = rigid_modes(result, box.size / 2);
  system.F = MatrixXd(system.M.rows(), 0);
  system.u0 = system.v0 = VectorXd::Zero(system.M.rows());
  return result;
}

// No normal displacement and no shear on all six faces.
inline std::function<bool(const Vector3d&, int)> slip_faces(const Vector3d& size) {
  return [size](const Vector3d& x, int a) { return x[a] < 1e-9 * size[a] || x[a] > (1 - 1e-9) * size[a]; };
}

}  // namespace mb::testing
