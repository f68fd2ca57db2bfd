#include "reference/fem/finite_strain.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <limits>

#include "mechanics/geometry/pose.h"
#include "mechanics/system/system.h"

namespace mb::fem {

namespace {

using Eigen::Matrix3d;

// Columns of a field's gradient at point q among those of all points.
Matrix3d at_point(const MatrixXd& gradients, Index q, Index n_q) {
  Matrix3d H;
  for (Index k = 0; k < 3; ++k) H.col(k) = gradients.col(k * n_q + q);
  return H;
}

// x -> t + w x (x - c) as a 3 x 6 matrix acting on (t, w).
Eigen::Matrix<double, 3, 6> twist_at(const Vector3d& arm) {
  Eigen::Matrix<double, 3, 6> at;
  at.leftCols<3>().setIdentity();
  at.rightCols<3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
  return at;
}

MatrixXd twist_fields(const Matrix3Xd& x, const Vector3d& centre, const std::vector<Index>& kept) {
  MatrixXd fields(static_cast<Index>(kept.size()), 6);
  for (size_t k = 0; k < kept.size(); ++k)
    fields.row(static_cast<Index>(k)) = twist_at(x.col(kept[k] / 3) - centre).row(kept[k] % 3);
  return fields;
}

}  // namespace

FiniteStrain::FiniteStrain(const Discretisation& d, const Supports& supports, const Material& material,
                           const System& system)
    : c_(lame(material)),
      beta_(system.damping.beta),
      T_(supports.T),
      all_free_(T_.rows() == T_.cols()),
      kept_(supports.kept),
      X_(d.node_positions()),
      centroid_(Vector3d::Zero()) {
  const dealii::QGauss<3> gauss(d.element.degree + 1);
  dealii::FEValues<3> values(d.mapping, d.element, gauss, dealii::update_gradients | dealii::update_JxW_values);
  const Index n = d.element.n_dofs_per_cell(), n_q = gauss.size();
  std::vector<dealii::types::global_dof_index> ids(static_cast<size_t>(n));
  const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = T_;
  for (const auto& from : d.nodes.active_cell_iterators()) {
    values.reinit(from);
    from->get_dof_indices(ids);
    Cell cell{{ids.begin(), ids.end()}, MatrixXd(n, 3 * n_q), VectorXd(n_q), MatrixXd::Zero(n, n), {}};
    for (unsigned q = 0; q < gauss.size(); ++q) {
      cell.w[q] = values.JxW(q);
      for (unsigned a = 0; a < ids.size(); ++a)
        for (unsigned k = 0; k < 3; ++k) cell.gradients(a, k * n_q + q) = values.shape_grad(a, q)[k];
    }
    for (Index k = 0; k < 3; ++k) {
      const auto dN = cell.gradients.middleCols(k * n_q, n_q);
      cell.laplacian.noalias() += dN * cell.w.asDiagonal() * dN.transpose();
    }
    condense(cell, rows, system.K);
    cells_.push_back(std::move(cell));
  }
  if (system.R.cols() == 6) {  // moves as a whole: its unknowns come by nodes
    const VectorXd X = X_.reshaped()(kept_), MX = system.M * X;
    const double mass = system.M.sum() / 3;
    centroid_ = MX.reshaped(3, MX.size() / 3).rowwise().sum() / mass;
    const VectorXd one = centroid_.replicate(X.size() / 3, 1);
    mass_by_X_ = (MX - system.M * one).reshaped(3, X.size() / 3).transpose();
  }
  twists_.resize(6, system.R.cols());
  // Held bodies have none: Eigen would solve for what is not there, by a reference to null.
  if (twists_.cols() > 0) twists_ = twist_fields(X_, centroid_, kept_).colPivHouseholderQr().solve(system.R);
}

VectorXd FiniteStrain::at_nodes(const VectorXd& u) const { return all_free_ ? u : VectorXd(T_ * u); }

double FiniteStrain::energy(const VectorXd& u) const {
  const VectorXd nodal = at_nodes(u);
  const auto u_a = nodal.reshaped(3, X_.cols());
  double sum = 0;
  for (const Cell& cell : cells_) {
    const Index n_q = cell.w.size();
    const MatrixXd H = u_a(Eigen::all, cell.nodes) * cell.gradients;
    for (Index q = 0; q < n_q; ++q) {
      const auto now = deformation(Matrix3d::Identity() + at_point(H, q, n_q));
      if (!now) return std::numeric_limits<double>::infinity();
      sum += cell.w[q] * neo_hookean::energy(c_, *now);
    }
  }
  return sum;
}

bool FiniteStrain::force(const VectorXd& u, const VectorXd& v, VectorXd& f) const {
  const VectorXd nodal = at_nodes(u), rates = beta_ != 0 ? at_nodes(v) : VectorXd();
  const auto u_a = nodal.reshaped(3, X_.cols());
  const Index n = cells_.front().w.size() > 0 ? static_cast<Index>(cells_.front().nodes.size()) : 0;
  const Index n_q = cells_.front().w.size();
  VectorXd sum = VectorXd::Zero(3 * X_.cols());
  MatrixXd u_c(3, n), v_c(3, n), H(3, 3 * n_q), H_rate(3, 3 * n_q), P(3, 3 * n_q), f_c(3, n);
  for (const Cell& cell : cells_) {
    for (Index a = 0; a < n; ++a) u_c.col(a) = u_a.col(cell.nodes[static_cast<size_t>(a)]);
    H.noalias() = u_c * cell.gradients;
    if (beta_ != 0) {
      for (Index a = 0; a < n; ++a) v_c.col(a) = rates.segment<3>(3 * cell.nodes[static_cast<size_t>(a)]);
      H_rate.noalias() = v_c * cell.gradients;
    }
    for (Index q = 0; q < n_q; ++q) {
      const auto now = deformation(Matrix3d::Identity() + at_point(H, q, n_q));
      if (!now) return false;
      Matrix3d stress = neo_hookean::stress(c_, *now);
      if (beta_ != 0) stress += neo_hookean::viscous_stress(c_, beta_, now->F, at_point(H_rate, q, n_q));
      for (Index k = 0; k < 3; ++k) P.col(k * n_q + q) = cell.w[q] * stress.col(k);
    }
    f_c.noalias() = P * cell.gradients.transpose();
    for (Index a = 0; a < n; ++a) sum.segment<3>(3 * cell.nodes[static_cast<size_t>(a)]) += f_c.col(a);
  }
  if (all_free_)
    f = sum;
  else
    f.noalias() = T_.transpose() * sum;
  return true;
}

std::vector<Turn> FiniteStrain::turns(const VectorXd& u) const {
  if (mass_by_X_.rows() == 0) return {};
  const VectorXd x = u + X_.reshaped()(kept_);
  const Matrix3d correlation = x.reshaped(3, x.size() / 3) * mass_by_X_;
  return {{0, u.size(), nearest_rotation(correlation)}};
}

MatrixXd FiniteStrain::rigid_motions(const VectorXd& u) const {
  const VectorXd nodal = at_nodes(u);
  return twist_fields(X_ + nodal.reshaped(3, X_.cols()), centroid_, kept_) * twists_;
}

}  // namespace mb::fem
