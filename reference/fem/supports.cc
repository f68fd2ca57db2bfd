#include "reference/fem/supports.h"

#include <cmath>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"
#include "reference/fem/assembly.h"

namespace mb::fem {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Components, 1 or 0, which the support holds at every node of its face.
Vector3d held_components(const Shape& shape, const Support& support) {
  switch (support.kind) {
    case Support::Kind::fixed:
    case Support::Kind::driven:
      return Vector3d::Ones();
    case Support::Kind::sliding:
      return plane_normal(shape, support.patch.face).cwiseAbs();
    case Support::Kind::diaphragm:
      return Vector3d::Ones() - plane_normal(shape, support.patch.face).cwiseAbs();
    case Support::Kind::mean:
      return Vector3d::Zero();
  }
  throw std::invalid_argument("no such kind of support");
}

// Marks the components of the face's nodes that the support holds at zero.
void mark_fixed(const Discretisation& d, const Support& support, std::vector<bool>& fixed) {
  const auto id = static_cast<unsigned>(d.boundary_id(support.patch.face));
  const Vector3d held = held_components(d.shape, support);
  std::vector<dealii::types::global_dof_index> ids(d.element.n_dofs_per_face());
  for (const auto& cell : d.nodes.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || face->boundary_id() != id) continue;
      face->get_dof_indices(ids);
      for (const auto a : ids)
        for (size_t i = 0; i < 3; ++i)
          if (held[static_cast<Index>(i)] != 0) fixed[3 * a + i] = true;
    }
}

// What is held, and what hangs on what is not: T of the components that are neither. Where a hanging node is held, so
// are its masters: they lie on the same edge of the same face.
Supports free_components(const Discretisation& d, const std::vector<bool>& fixed) {
  Supports free;
  std::vector<Index> column(fixed.size(), -1);
  for (Index i = 0; i < d.n_dofs(); ++i) {
    const bool hangs = d.hanging.is_constrained(static_cast<dealii::types::global_dof_index>(i / 3));
    if (hangs || fixed[static_cast<size_t>(i)]) continue;
    column[static_cast<size_t>(i)] = std::ssize(free.kept);
    free.kept.push_back(i);
  }
  Triplets entries;
  for (size_t j = 0; j < free.kept.size(); ++j) entries.emplace_back(free.kept[j], static_cast<Index>(j), 1.0);
  for (const auto& hanging : d.hanging.get_lines())
    for (size_t i = 0; i < 3; ++i)
      for (const auto& [master, c] : hanging.entries) {
        const Index j = column[3 * master + i];
        const bool held = fixed[3 * hanging.index + i];
        if (held && j >= 0 && std::abs(c) > 1e-12) throw std::logic_error("a held node hangs on one that is not");
        if (!held && j >= 0) entries.emplace_back(static_cast<Index>(3 * hanging.index + i), j, c);
      }
  free.T.resize(d.n_dofs(), std::ssize(free.kept));
  free.T.setFromTriplets(entries.begin(), entries.end());
  return free;
}

// Adds c^T T u = 0: the entry with the largest coefficient follows from the others.
void eliminate(const VectorXd& c_full, Supports& s) {
  const VectorXd c = s.T.transpose() * c_full;
  Index pivot = 0;
  const double largest = c.cwiseAbs().maxCoeff(&pivot);
  if (largest <= 1e-12 * c_full.cwiseAbs().maxCoeff()) return;  // already implied by the other supports
  Triplets entries;
  for (Index j = 0, column = 0; j < c.size(); ++j) {
    if (j == pivot) continue;
    entries.emplace_back(j, column, 1.0);
    if (c[j] != 0) entries.emplace_back(pivot, column, -c[j] / c[pivot]);
    ++column;
  }
  SparseMatrix step(c.size(), c.size() - 1);
  step.setFromTriplets(entries.begin(), entries.end());
  s.T = (s.T * step).eval();
  s.kept.erase(s.kept.begin() + pivot);
}

// Columns: translations and rotations about the centre, in the nodes' values; rotations scaled by the extent.
MatrixXd rigid_motions(const Discretisation& d) {
  const Matrix3Xd x = d.node_positions();
  MatrixXd R = MatrixXd::Zero(d.n_dofs(), 6);
  for (Index a = 0; a < d.n_nodes(); ++a)
    for (int i = 0; i < 3; ++i) {
      R(3 * a + i, i) = 1;
      R.block<3, 1>(3 * a, 3 + i) = Vector3d::Unit(i).cross(Vector3d(x.col(a))) / extent(d.shape);
    }
  return R;
}

// Combinations of the fields' columns (at least as many rows) that T reproduces from their values at the free degrees
// of freedom: those values, n_free x m, and m maybe 0.
MatrixXd admitted(const Supports& supports, const MatrixXd& fields) {
  const Index k = fields.cols();
  MatrixXd free(static_cast<Index>(supports.kept.size()), k);
  for (Index i = 0; i < free.rows(); ++i) free.row(i) = fields.row(supports.kept[static_cast<size_t>(i)]);
  // fields c = T free c. Thin SVD through the k x k triangle.
  const MatrixXd violation = fields - supports.T * free;
  const double held = 1e-10 * fields.norm();
  if (violation.norm() <= held) return free;  // in the order of the fields
  const MatrixXd triangle = violation.householderQr().matrixQR().topRows(k).triangularView<Eigen::Upper>();
  const auto [U, sigma, V] = thin_svd(triangle);
  Index m = 0;
  while (m < k && sigma[k - 1 - m] <= held) ++m;
  return free * V.rightCols(m);
}

// Values at the nodes of orthonormal combinations of x^i y^j z^k, i + j + k <= degree, about the centre: n_nodes x m.
// Hanging nodes take what their masters give them.
MatrixXd scalar_polynomials(const Discretisation& d, int degree) {
  Matrix3Xd x = d.node_positions();
  for (int i = 0; i < 3; ++i) x.row(i) /= x.row(i).cwiseAbs().maxCoeff();  // to [-1, 1]
  MatrixXd P(x.cols(), (degree + 1) * (degree + 2) * (degree + 3) / 6);
  Index column = 0;
  for (int total = 0; total <= degree; ++total)
    for (int i = total; i >= 0; --i)
      for (int j = total - i; j >= 0; --j)
        P.col(column++) =
            (x.row(0).array().pow(i) * x.row(1).array().pow(j) * x.row(2).array().pow(total - i - j)).transpose();
  for (const auto& hanging : d.hanging.get_lines()) {
    auto row = P.row(static_cast<Index>(hanging.index));
    row.setZero();
    for (const auto& [master, c] : hanging.entries) row += c * P.row(static_cast<Index>(master));
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(P);
  qr.setThreshold(1e-10);  // monomials of low degree on [-1, 1] are far from dependent, unless the nodes are too few
  return qr.householderQ() * MatrixXd::Identity(P.rows(), qr.rank());
}

}  // namespace

Supports condense(const Discretisation& d, const std::vector<Support>& supports) {
  std::vector<bool> fixed(static_cast<size_t>(d.n_dofs()), false);
  for (const Support& support : supports)
    if (support.kind != Support::Kind::mean) mark_fixed(d, support, fixed);
  Supports result = free_components(d, fixed);
  for (const Support& support : supports)
    if (support.kind == Support::Kind::mean) eliminate(patch_normal(d, support.patch), result);
  if (result.kept.empty()) throw std::invalid_argument("the supports leave nothing free");
  return result;
}

std::optional<Drive> common_drive(const std::vector<Support>& supports) {
  std::optional<Drive> drive;
  for (const Support& support : supports) {
    if (support.drive.has_value() != (support.kind == Support::Kind::driven))
      throw std::invalid_argument("driven supports, and no others, state a drive");
    if (!support.drive) continue;
    const auto& [direction, acceleration] = *support.drive;
    if (!(std::abs(direction.norm() - 1) <= 1e-9))
      throw std::invalid_argument("the direction of a drive must be of unit length");
    if (drive && !(drive->direction == direction && drive->acceleration == acceleration))
      throw std::invalid_argument("all driven supports of a body ride on one base: they must state the same drive");
    drive = support.drive;
  }
  return drive;
}

VectorXd translation(const Discretisation& d, const Vector3d& direction) { return direction.replicate(d.n_nodes(), 1); }

MatrixXd polynomials(const Discretisation& d, const Supports& supports, int degree) {
  if (degree < 0) throw std::invalid_argument("polynomials: the degree must not be negative");
  const MatrixXd scalar = scalar_polynomials(d, degree);
  MatrixXd fields = MatrixXd::Zero(d.n_dofs(), 3 * scalar.cols());
  for (Index a = 0; a < d.n_nodes(); ++a)
    for (Index j = 0; j < scalar.cols(); ++j) fields.block<3, 3>(3 * a, 3 * j).diagonal().setConstant(scalar(a, j));
  return admitted(supports, fields);
}

MatrixXd free_rigid_modes(const Discretisation& d, const Supports& supports, const SparseMatrix& M) {
  MatrixXd R = admitted(supports, rigid_motions(d));
  for (int pass = 0; pass < 2; ++pass) {  // twice is enough: orthonormal to rounding
    const Eigen::LLT<MatrixXd> gram(R.transpose() * (M * R));
    gram.matrixU().solveInPlace<Eigen::OnTheRight>(R);
  }
  return R;
}

}  // namespace mb::fem
