#include "mechanics/contact/contact_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {

namespace {

constexpr int max_iterations = 40, max_halvings = 12;

// Infinity where anything is not finite, which the norm alone may overlook.
double largest(const VectorXd& r) {
  return std::isfinite(r.sum()) ? r.lpNorm<Eigen::Infinity>() : std::numeric_limits<double>::infinity();
}

}  // namespace

void ContactStage::forget() {
  std::ranges::fill(column_, -1);
  known_.clear();
}

void ContactStage::require_columns(const Inverse& A, const std::vector<Index>& active, Outcome& outcome) {
  std::vector<Index> missing, unknowns;
  for (const Index c : active) {
    if (column_[static_cast<size_t>(c)] >= 0) continue;
    missing.push_back(c);
    unknowns.push_back(forces_.dofs()[static_cast<size_t>(c)]);
  }
  if (missing.empty()) return;
  const MatrixXd found = A.columns(unknowns, n_);
  for (size_t k = 0; k < missing.size(); ++k) {
    const auto at = static_cast<Index>(known_.size());
    if (at >= inverse_.cols()) {
      const Index more = std::max<Index>(32, 2 * inverse_.cols());
      inverse_.conservativeResize(n_, more);
      inverse_C_.conservativeResize(static_cast<Index>(column_.size()), more);
    }
    inverse_.col(at) = found.col(static_cast<Index>(k));
    inverse_C_.col(at) = forces_.gather(inverse_.col(at));
    column_[static_cast<size_t>(missing[k])] = at;
    known_.push_back(missing[k]);
  }
  outcome.solves += static_cast<long>(missing.size());
}

MatrixXd ContactStage::compliance(const std::vector<Index>& rows, const std::vector<Index>& columns) const {
  std::vector<Index> at;
  for (const Index c : columns) at.push_back(column_[static_cast<size_t>(c)]);
  return inverse_C_(rows, at);
}

VectorXd ContactStage::response(const VectorXd& f_C) const {
  return inverse_C_.leftCols(static_cast<Index>(known_.size())) * f_C(known_);
}

ContactStage::Outcome ContactStage::solve(const Inverse& A, const VectorXd& a, double gamma, double tolerance,
                                          VectorXd& v) {
  Outcome outcome{true, 0, 0, {}};
  const VectorXd a_C = forces_.gather(a), vhat_C = forces_.gather(v);
  VectorXd v_C = vhat_C;
  f_.resize(v_C.size());
  ContactForces::Tangent tangent;
  // r = v - vhat - gamma G f: f acts on known columns alone once those of the tangent are there.
  const auto residual_at = [&](const VectorXd& v_now) {
    outcome.sum = forces_(a_C + gamma * v_now, v_now, f_, tangent);
    require_columns(A, tangent.active, outcome);
    return VectorXd(v_now - vhat_C - gamma * response(f_));
  };
  VectorXd r = residual_at(v_C);
  for (double size = largest(r); size > tolerance; size = largest(r), ++outcome.iterations) {
    if (!std::isfinite(size) || outcome.iterations == max_iterations) return outcome.converged = false, outcome;
    // Rows off J follow those of J: dv_C = -r + gamma G_CJ (gamma K_x + K_v) dv_J.
    const std::vector<Index> J = tangent.active;
    const MatrixXd K = gamma * (gamma * tangent.by_u + tangent.by_v);
    const auto n_J = static_cast<Index>(J.size());
    VectorXd step = -r;
    if (n_J > 0) {
      const MatrixXd jacobian = MatrixXd::Identity(n_J, n_J) - compliance(J, J) * K;
      const VectorXd step_J = jacobian.partialPivLu().solve(VectorXd(-r(J)));
      VectorXd pushed = VectorXd::Zero(v_C.size());
      pushed(J) = K * step_J;
      step += response(pushed);
    }
    // The part taken is that of the last residual, whether it fell or not: forces and tangent are of there.
    double part = 1;
    r = residual_at(v_C + step);
    for (int halving = 0; halving < max_halvings && !(largest(r) < (1 - 0.1 * part) * size); ++halving) {
      part /= 2;
      r = residual_at(v_C + part * step);
    }
    v_C += part * step;
  }
  if (!known_.empty() && !f_.isZero(0))
    v.noalias() += gamma * (inverse_.leftCols(static_cast<Index>(known_.size())) * f_(known_));
  return outcome;
}

}  // namespace mb
