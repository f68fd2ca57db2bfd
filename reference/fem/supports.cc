#include "reference/fem/supports.h"

#include <stdexcept>

#include "reference/fem/assembly.h"

namespace mb::fem {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Marks the components of the face's nodes that the support holds at zero.
void mark_fixed(const Discretisation& d, const Support& support, std::vector<bool>& fixed) {
  const auto id = static_cast<unsigned>(d.boundary_id(support.patch.face));
  Vector3d held = Vector3d::Ones();
  if (support.kind == Support::Kind::sliding) held = plane_normal(d.shape, support.patch.face).cwiseAbs();
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

SparseMatrix selection(Index n, const std::vector<Index>& kept) {
  Triplets entries;
  for (size_t j = 0; j < kept.size(); ++j) entries.emplace_back(kept[j], static_cast<Index>(j), 1.0);
  SparseMatrix T(n, static_cast<Index>(kept.size()));
  T.setFromTriplets(entries.begin(), entries.end());
  return T;
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

}  // namespace

Supports condense(const Discretisation& d, const std::vector<Support>& supports) {
  std::vector<bool> fixed(static_cast<size_t>(d.n_dofs()), false);
  for (const Support& support : supports)
    if (support.kind != Support::Kind::mean) mark_fixed(d, support, fixed);
  Supports result;
  for (Index i = 0; i < d.n_dofs(); ++i)
    if (!fixed[static_cast<size_t>(i)]) result.kept.push_back(i);
  result.T = selection(d.n_dofs(), result.kept);
  for (const Support& support : supports)
    if (support.kind == Support::Kind::mean) eliminate(patch_normal(d, support.patch), result);
  if (result.kept.empty()) throw std::invalid_argument("the supports leave nothing free");
  return result;
}

MatrixXd free_rigid_modes(const Discretisation& d, const Supports& supports, const SparseMatrix& M) {
  const MatrixXd rigid = rigid_motions(d);
  MatrixXd R(static_cast<Index>(supports.kept.size()), 6);
  for (Index i = 0; i < R.rows(); ++i) R.row(i) = rigid.row(supports.kept[static_cast<size_t>(i)]);
  // A combination c is free where T reproduces it: rigid c = T R c. Thin SVD through the 6 x 6 triangle.
  const MatrixXd violation = rigid - supports.T * R;
  const MatrixXd triangle = violation.householderQr().matrixQR().topRows<6>().triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<MatrixXd> svd(triangle, Eigen::ComputeFullV);
  Index n_free = 0;
  while (n_free < 6 && svd.singularValues()[5 - n_free] <= 1e-10 * rigid.norm()) ++n_free;
  R = (R * svd.matrixV().rightCols(n_free)).eval();
  for (int pass = 0; pass < 2; ++pass) {  // twice is enough: orthonormal to rounding
    const Eigen::LLT<MatrixXd> gram(R.transpose() * (M * R));
    gram.matrixU().solveInPlace<Eigen::OnTheRight>(R);
  }
  return R;
}

}  // namespace mb::fem
