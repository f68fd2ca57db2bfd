#include "reference/fem/assembly.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "mechanics/geometry/disc_rule.h"
#include "reference/fem/evaluation.h"

namespace mb::fem {

namespace {

using Indices = std::vector<dealii::types::global_dof_index>;

// Pattern of node couplings, column by column, rows ascending.
SparseMatrix node_pattern(const Discretisation& d) {
  std::vector<std::vector<int>> rows(static_cast<size_t>(d.n_nodes()));
  Indices ids(d.element.n_dofs_per_cell());
  for (const auto& cell : d.nodes.active_cell_iterators()) {
    cell->get_dof_indices(ids);
    for (const auto b : ids) rows[b].insert(rows[b].end(), ids.begin(), ids.end());
  }
  SparseMatrix pattern(d.n_nodes(), d.n_nodes());
  for (Index b = 0; b < d.n_nodes(); ++b) {
    auto& r = rows[static_cast<size_t>(b)];
    std::sort(r.begin(), r.end());
    r.erase(std::unique(r.begin(), r.end()), r.end());
    pattern.startVec(b);
    for (const int a : r) pattern.insertBack(a, b) = 0;
    r = {};
  }
  pattern.finalize();
  return pattern;
}

// The pattern with every entry a 3 x 3 block (full or diagonal), values zero.
SparseMatrix expand(const SparseMatrix& pattern, bool full_blocks) {
  SparseMatrix A(3 * pattern.rows(), 3 * pattern.cols());
  A.reserve(pattern.nonZeros() * (full_blocks ? 9 : 3));
  for (Index b = 0; b < pattern.cols(); ++b)
    for (Index j = 0; j < 3; ++j) {
      A.startVec(3 * b + j);
      for (SparseMatrix::InnerIterator it(pattern, b); it; ++it)
        for (Index i = full_blocks ? 0 : j; i < (full_blocks ? 3 : j + 1); ++i)
          A.insertBack(3 * it.row() + i, 3 * b + j) = 0;
    }
  A.finalize();
  return A;
}

// Position of row a among the entries of column b of the node pattern.
int position(const SparseMatrix& pattern, int a, int b) {
  const int* first = pattern.innerIndexPtr() + pattern.outerIndexPtr()[b];
  const int* last = pattern.innerIndexPtr() + pattern.outerIndexPtr()[b + 1];
  return static_cast<int>(std::lower_bound(first, last, a) - first);
}

// N and its gradients at the quadrature points of one cell, rows: points, columns: nodes. f: what the material's
// stiffness is multiplied by there.
struct CellValues {
  MatrixXd N;                  // sqrt(w) N
  std::array<MatrixXd, 3> dN;  // sqrt(w f) d_k N
};
void evaluate(const dealii::FEValues<3>& values, const Material& material, CellValues& cell) {
  for (unsigned q = 0; q < values.n_quadrature_points; ++q) {
    const double root = std::sqrt(values.JxW(q));
    const auto& x = values.quadrature_point(q);
    const double stiff_root = root * std::sqrt(stiffness_factor(material, {x[0], x[1], x[2]}));
    for (unsigned a = 0; a < values.dofs_per_cell; ++a) {
      cell.N(q, a) = root * values.shape_value(a, q);
      const auto& gradient = values.shape_grad(a, q);
      for (unsigned k = 0; k < 3; ++k) cell.dN[k](q, a) = stiff_root * gradient[k];
    }
  }
}

// C_ikjl of sigma_ik = C_ikjl eps_jl from the Voigt matrix.
double elasticity(const Matrix6d& D, int i, int k, int j, int l) {
  static constexpr int voigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  return D(voigt[i][k], voigt[j][l]);
}

// Blocks K_ij of one cell: n_nodes x n_nodes each.
using Blocks = std::array<std::array<MatrixXd, 3>, 3>;
void stiffness_blocks(const Matrix6d& D, const CellValues& cell, Blocks& K) {
  for (auto& row : K)
    for (auto& block : row) block.setZero();
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l) {
      const MatrixXd G = cell.dN[k].transpose() * cell.dN[l];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          if (const double C = elasticity(D, i, k, j, l); C != 0) K[i][j] += C * G;
    }
}

// Adds the cell's mass and stiffness blocks at the places of its nodes.
void scatter(const SparseMatrix& pattern, const Indices& ids, const MatrixXd& mass, const Blocks& stiffness,
             Matrices& sum) {
  double* const m = sum.M.valuePtr();
  double* const k = sum.K.valuePtr();
  for (Index b = 0; b < mass.cols(); ++b)
    for (Index a = 0; a < mass.rows(); ++a) {
      const int row = static_cast<int>(ids[static_cast<size_t>(a)]),
                col = static_cast<int>(ids[static_cast<size_t>(b)]);
      const int at = position(pattern, row, col);
      for (int j = 0; j < 3; ++j) {
        m[sum.M.outerIndexPtr()[3 * col + j] + at] += mass(a, b);
        for (int i = 0; i < 3; ++i) k[sum.K.outerIndexPtr()[3 * col + j] + 3 * at + i] += stiffness[i][j](a, b);
      }
    }
}

}  // namespace

Matrices assemble(const Discretisation& d, const Material& material) {
  const SparseMatrix pattern = node_pattern(d);
  Matrices sum{expand(pattern, false), expand(pattern, true), 0};
  const Matrix6d D = elasticity_matrix(material);
  const dealii::QGauss<3> gauss(d.element.degree + 1);
  dealii::FEValues<3> values(
      d.mapping, d.element, gauss,
      dealii::update_values | dealii::update_gradients | dealii::update_JxW_values | dealii::update_quadrature_points);
  const Index n = d.element.n_dofs_per_cell(), n_q = gauss.size();
  CellValues cell_values{MatrixXd(n_q, n), {MatrixXd(n_q, n), MatrixXd(n_q, n), MatrixXd(n_q, n)}};
  Blocks stiffness;
  for (auto& row : stiffness) row.fill(MatrixXd(n, n));
  Indices ids(static_cast<size_t>(n));
  for (const auto& cell : d.nodes.active_cell_iterators()) {
    values.reinit(cell);
    evaluate(values, material, cell_values);
    stiffness_blocks(D, cell_values, stiffness);
    const MatrixXd mass = material.density * (cell_values.N.transpose() * cell_values.N);
    cell->get_dof_indices(ids);
    scatter(pattern, ids, mass, stiffness, sum);
  }
  sum.mesh_volume = mesh_volume(d);
  return sum;
}

double mesh_volume(const Discretisation& d) {
  const dealii::QGauss<3> gauss(d.element.degree + 1);
  dealii::FEValues<3> values(d.mapping, d.element, gauss, dealii::update_JxW_values);
  double sum = 0;
  for (const auto& cell : d.nodes.active_cell_iterators()) {
    values.reinit(cell);
    for (unsigned q = 0; q < gauss.size(); ++q) sum += values.JxW(q);
  }
  return sum;
}

VectorXd lumped_mass(const Discretisation& d, double density) {
  // FE_Q of degree p has its nodes at the p + 1 points of this rule, numbered as dofs are, not as points are.
  const dealii::QGaussLobatto<3> lobatto(d.element.degree + 1);
  dealii::FEValues<3> values(d.mapping, d.element, lobatto, dealii::update_values | dealii::update_JxW_values);
  VectorXd mass = VectorXd::Zero(d.n_nodes());
  Indices ids(d.element.n_dofs_per_cell());
  for (const auto& cell : d.nodes.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(ids);
    for (unsigned q = 0; q < lobatto.size(); ++q)
      for (unsigned a = 0; a < ids.size(); ++a)
        mass[static_cast<Index>(ids[a])] += density * values.shape_value(a, q) * values.JxW(q);
  }
  Index lightest = 0;
  if (!(mass.minCoeff(&lightest) > 0)) {
    const Vector3d x = d.node_positions().col(lightest);
    throw std::invalid_argument(
        fmt::format("lumped mass {:.3g} kg at ({:.4g}, {:.4g}, {:.4g}) m is not positive: degenerate cells or density",
                    mass[lightest], x[0], x[1], x[2]));
  }
  return mass.replicate(1, 3).transpose().reshaped();
}

namespace {

using BoundaryField = std::function<Vector3d(const Vector3d& normal)>;

// int_face f(n) N_a dA over the mesh's face.
VectorXd integrate_face(const Discretisation& d, const std::string& name, const BoundaryField& f) {
  const dealii::QGauss<2> gauss(d.element.degree + 2);
  dealii::FEFaceValues<3> values(d.mapping, d.element, gauss,
                                 dealii::update_values | dealii::update_JxW_values | dealii::update_normal_vectors);
  const auto id = static_cast<unsigned>(d.boundary_id(name));
  VectorXd load = VectorXd::Zero(d.n_dofs());
  Indices ids(d.element.n_dofs_per_cell());
  for (const auto& cell : d.nodes.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || face->boundary_id() != id) continue;
      values.reinit(cell, face);
      cell->get_dof_indices(ids);
      for (unsigned q = 0; q < gauss.size(); ++q) {
        const auto& n = values.normal_vector(q);
        const Vector3d wf = values.JxW(q) * f(Vector3d(n[0], n[1], n[2]));
        for (unsigned a = 0; a < ids.size(); ++a)
          load.segment<3>(3 * static_cast<Index>(ids[a])) += values.shape_value(a, q) * wf;
      }
    }
  return load;
}

// Mean distance of nodes [m] along the shortest edge of the faces of the mesh that the disc may meet.
double node_spacing(const Discretisation& d, const Patch& patch) {
  const Disc& disc = *patch.disc;
  const dealii::Point<3> centre(disc.centre[0], disc.centre[1], disc.centre[2]);
  const auto id = static_cast<unsigned>(d.boundary_id(patch.face));
  double least = 2 * disc.radius;
  for (const auto& cell : d.nodes.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == id &&
          face->center().distance(centre) < disc.radius + face->diameter())
        for (unsigned edge = 0; edge < 4; ++edge)
          least = std::min(least, face->line(edge)->diameter() / d.element.degree);
  return least;
}

// int_disc w f(n) N_a dA over the exact disc: force and moment are the same on every mesh, which whole-face quadrature
// of a weight with compact support would not give. Shape functions bend where cells meet: four points a node.
VectorXd integrate_disc(const Discretisation& d, const Patch& patch, const BoundaryField& f) {
  const DiscRule rule = disc_rule(d.shape, patch, node_spacing(d, patch) / 4);
  Matrix3Xd wf(3, rule.weights.size());
  for (Index i = 0; i < wf.cols(); ++i) wf.col(i) = rule.weights[i] * f(rule.normals.col(i));
  return nodal_loads(d, rule.points, wf);
}

VectorXd integrate_patch(const Discretisation& d, const Patch& patch, const BoundaryField& f) {
  return patch.disc ? integrate_disc(d, patch, f) : integrate_face(d, patch.face, f);
}

}  // namespace

VectorXd patch_load(const Discretisation& d, const Patch& patch, const Vector3d& traction, double pressure) {
  return integrate_patch(d, patch, [&](const Vector3d& n) -> Vector3d { return traction - pressure * n; });
}

VectorXd patch_normal(const Discretisation& d, const Patch& patch) {
  return integrate_patch(d, patch, [](const Vector3d& n) { return n; });
}

}  // namespace mb::fem
