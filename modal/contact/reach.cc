#include "modal/contact/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "modal/contact/sample_tables.h"

namespace mb {

namespace {

constexpr Index n_least = 64;  // samples in a list
constexpr Index n_spare = 4;   // [-] list by samples that press

Wander of_samples(const SampledContact& contact) {
  const Matrix3Xd& X = contact.samples.X;
  const auto tables = tables_of(contact);
  return {X.cols() > 0 ? std::sqrt(X.colwise().squaredNorm().maxCoeff()) : 0, tables->largest_q, tables->largest_s};
}

std::optional<Wander> of_partner(const SampledContact& contact) {
  if (!contact.partner) return {};
  return Wander(contact.partner->radius, contact.partner->largest_q, contact.partner->largest_s);
}

}  // namespace

Wander::Wander(double longest, VectorXd largest_q, VectorXd largest_s)
    : longest_(longest), largest_q_(std::move(largest_q)), largest_s_(std::move(largest_s)) {}

void Wander::look(const BodyState& state) { c_ = state.c, Q_ = state.Q, q_ = state.q, s_ = state.s; }

// |Q x - Q' x'| <= |Q - Q'| |x'| + |x - x'|, and |Q - Q'| <= 2 |sin(angle/2)| = 2 |vec(Q^-1 Q')|.
double Wander::operator()(const BodyState& state) const {
  const Eigen::Quaterniond &Q = state.Q, &P = Q_;
  const double way = (state.c - c_).norm() + largest_q_.dot((state.q - q_).cwiseAbs()) + static_way(state.s, s_);
  if (Q.coeffs() == P.coeffs()) return way;
  const double sine = (Q.vec() * P.w() - P.vec() * Q.w() - Q.vec().cross(P.vec())).norm();
  return way + 2 * sine * (longest_ + largest_q_.dot(q_.cwiseAbs()) + largest_s_.dot(s_.cwiseAbs()));
}

Reach::Reach(const SampledContact& contact)
    : n_samples_(contact.samples.X.cols()), own_(of_samples(contact)), partner_(of_partner(contact)) {
  list_.beyond = -1;
}

bool ListSize::enough(const Neighbours& list) const {
  const auto n = std::ssize(list.order);
  if (n < n_least) return false;
  return n >= n_spare * (std::ranges::upper_bound(list.gap, margin) - list.gap.begin());
}

bool Reach::spent(const BodyState& state, const BodyState* partner) const {
  return list_.beyond < 0 || in_vain_ > list_.n_looked || !(moved(state, partner) + margin_ < list_.beyond);
}

ListSize Reach::size() const { return {n_least, n_spare, margin_}; }

Neighbours Reach::nearest(const VectorXd& gaps) {
  Neighbours list{std::move(list_.order), std::move(list_.gap), -1, n_samples_};
  list.gap.clear();
  if (!std::isfinite(gaps.sum())) return list;  // nothing presses in a state that is none
  list.order.resize(static_cast<size_t>(n_samples_));
  std::iota(list.order.begin(), list.order.end(), Index{0});
  const auto by_gap = [&](Index i, Index j) { return gaps[i] < gaps[j]; };
  const auto n = std::min(n_samples_, std::max(n_least, n_spare * (gaps.array() <= margin_).count()));
  if (n < n_samples_) std::ranges::nth_element(list.order, list.order.begin() + n, by_gap);
  std::sort(list.order.begin(), list.order.begin() + n, by_gap);
  list.beyond = n < n_samples_ ? gaps[list.order[static_cast<size_t>(n)]] : std::numeric_limits<double>::infinity();
  for (Index k = 0; k < n; ++k) list.gap.push_back(gaps[list.order[static_cast<size_t>(k)]]);
  return list;
}

void Reach::renew(const BodyState& state, const BodyState* partner, Neighbours list) {
  own_.look(state);
  if (partner) partner_->look(*partner);
  in_vain_ = 0;
  ++n_lists_;
  list_ = std::move(list);
}

Index Reach::count(const BodyState& state, const BodyState* partner) {
  n_ = std::ranges::upper_bound(list_.gap, moved(state, partner) + margin_) - list_.gap.begin();
  return n_;
}

double Reach::beyond(const BodyState& state, const BodyState* partner) const {
  const auto n = static_cast<size_t>(n_);
  return (n < list_.gap.size() ? list_.gap[n] : list_.beyond) - moved(state, partner);
}

bool Reach::covers(const VectorXd& s, const VectorXd* partner_s) {
  const double way = own_.static_way(s, s_) + (partner_s ? partner_->static_way(*partner_s, partner_s_) : 0);
  const bool covered = way <= margin_;
  margin_ = std::max(2 * way, 0.8 * margin_);
  return covered;
}

}  // namespace mb
