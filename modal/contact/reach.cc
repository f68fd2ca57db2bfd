#include "modal/contact/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "modal/contact/sample_tables.h"

namespace mb {

namespace {

constexpr Index n_least = 64;  // samples in a list
constexpr Index n_spare = 4;   // [-] list by samples that press

}  // namespace

Reach::Reach(const SampledContact& contact)
    : n_samples_(contact.samples.X.cols()),
      longest_(n_samples_ > 0 ? std::sqrt(contact.samples.X.colwise().squaredNorm().maxCoeff()) : 0),
      order_(static_cast<size_t>(n_samples_)) {
  const auto tables = tables_of(contact);
  largest_q_ = tables->largest_q, largest_s_ = tables->largest_s;
  std::iota(order_.begin(), order_.end(), Index{0});
}

// |Q x - Q' x'| <= |Q - Q'| |x'| + |x - x'|, and |Q - Q'| <= 2 |sin(angle/2)| = 2 |vec(Q^-1 Q')|.
double Reach::moved(const BodyState& state) const {
  const Eigen::Quaterniond &Q = state.Q, &P = Q_;
  const double way =
      (state.c - c_).norm() + largest_q_.dot((state.q - q_).cwiseAbs()) + largest_s_.dot((state.s - s_).cwiseAbs());
  if (Q.coeffs() == P.coeffs()) return way;
  const double sine = (Q.vec() * P.w() - P.vec() * Q.w() - Q.vec().cross(P.vec())).norm();
  return way + 2 * sine * (longest_ + largest_q_.dot(q_.cwiseAbs()) + largest_s_.dot(s_.cwiseAbs()));
}

bool Reach::spent(const BodyState& state) const {
  return beyond_ < 0 || in_vain_ > n_samples_ || !(moved(state) + margin_ < beyond_);
}

void Reach::renew(const BodyState& state, const VectorXd& gaps) {
  c_ = state.c, Q_ = state.Q, q_ = state.q, s_ = state.s;
  in_vain_ = 0;
  ++n_lists_;
  beyond_ = -1;
  gap_.clear();
  if (!std::isfinite(gaps.sum())) return;  // nothing presses in a state that is none
  const auto by_gap = [&](Index i, Index j) { return gaps[i] < gaps[j]; };
  const auto n = std::min(n_samples_, std::max(n_least, n_spare * (gaps.array() <= margin_).count()));
  if (n < n_samples_) std::ranges::nth_element(order_, order_.begin() + n, by_gap);
  std::sort(order_.begin(), order_.begin() + n, by_gap);
  beyond_ = n < n_samples_ ? gaps[order_[static_cast<size_t>(n)]] : std::numeric_limits<double>::infinity();
  for (Index k = 0; k < n; ++k) gap_.push_back(gaps[order_[static_cast<size_t>(k)]]);
}

Index Reach::count(const BodyState& state) {
  n_ = std::ranges::upper_bound(gap_, moved(state) + margin_) - gap_.begin();
  return n_;
}

bool Reach::covers(const VectorXd& s) {
  const double way = largest_s_.dot((s - state_s_).cwiseAbs());
  const bool covered = way <= margin_;
  margin_ = std::max(2 * way, 0.8 * margin_);
  return covered;
}

}  // namespace mb
