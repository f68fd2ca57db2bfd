#include "modal/contact/body_pair.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "mechanics/geometry/signed_distance.h"
#include "modal/contact/sample_tables.h"

namespace mb {

namespace {

constexpr int n_rounds = 2;          // of a foot at most; each leaves the strain's part of the error
constexpr double still = 1e-4;       // [-] of the size: a foot that moves no farther is found, to second order
constexpr double surely = 0.8;       // [-] of a distance at rest, of what is far: no strain takes more
constexpr double most_scaled = 1.1;  // [-] of a foot, by the box in which the modes are known

Vector3d projected(const Shape& shape, const Vector3d& Z) {
  const Distance d = signed_distance(shape, Z);
  return Z - d.value * d.gradient;
}

}  // namespace

BodyPair::BodyPair(const FloatingBody& a, const FloatingBody& b, const SampledContact& contact)
    : a_(a),
      b_(b),
      contact_(contact),
      surface_(*contact.partner),
      reach_(contact),
      tables_(tables_of(contact)),
      tree_(tree_of(contact)),
      feels_rates_(contact.law.damping > 0 || contact.law.friction),
      feet_(surface_.feet) {}

void BodyPair::Near::reserve(Index m) {
  if (m <= gap.size()) return;
  m = std::max(2 * gap.size(), m);
  for (MatrixXd* of : {&Phi, &Psi, &Psi_b}) of->conservativeResize(of->rows(), 3 * m);
  for (Matrix3Xd* of : {&x, &v, &n, &Y, &y}) of->resize(3, m);
  gap.resize(m);
  gap_by_s.resize(Psi.rows() + Psi_b.rows(), m);
}

void BodyPair::meet(const BodyState& a, const BodyState& b) {
  Q_a_ = a.Q.toRotationMatrix(), Q_b_ = b.Q.toRotationMatrix();
  turn_ = Q_b_.transpose() * Q_a_;
  apart_ = Q_b_.transpose() * (a.c - b.c);
  map_.emplace(surface_.geometry.map(b.q));
}

void BodyPair::look(const Moving& a, const Moving& b) {
  at_a_ = a, at_b_ = b;
  meet(*a.state, *b.state);
  const auto list = [&](const ListSize& size) { return neighbours(*a.state, *b.state, size); };
  n_ = reach_.n_reachable(*a.state, list, b.state);
  if (n_ == 0) return;
  gather();
  find_feet();
  if (feels_rates_) find_rates(surface_.geometry.map(*b.rate));
}

void BodyPair::gather() {
  if (near_.gap.size() == 0) {
    near_.Phi.resize(a_.n_modes(), 0), near_.Psi.resize(a_.n_static(), 0), near_.Psi_b.resize(b_.n_static(), 0);
  }
  near_.reserve(n_);
  if (reach_.n_lists() != list_) list_ = reach_.n_lists(), n_gathered_ = 0;
  for (; n_gathered_ < n_; ++n_gathered_) {
    const Index i = reach_[n_gathered_];
    near_.Phi.middleCols(3 * n_gathered_, 3) = tables_->Phi.middleCols(3 * i, 3);
    near_.Psi.middleCols(3 * n_gathered_, 3) = tables_->Psi.middleCols(3 * i, 3);
    near_.Psi_b.middleCols(3 * n_gathered_, 3) = surface_.Psi.middleCols(3 * i, 3);
  }
}

// The nearest to Y of the box in which the modes of b are known, made larger by a factor: beyond it polynomials mean
// nothing.
Vector3d BodyPair::within_box(const Vector3d& Y, double larger) const {
  const Monomials& m = surface_.geometry.monomials();
  const Vector3d xi = m.scaled(Y);
  if ((xi.array().abs() <= larger).all()) return Y;
  return m.centre() + m.half_extents().cwiseProduct(xi.cwiseMax(-larger).cwiseMin(larger));
}

void BodyPair::find_feet() {
  const VectorXd u = near_.Phi.leftCols(3 * n_).transpose() * at_a_.state->q;
  Matrix3Xd target(3, n_);  // [m] samples in b's frame
  for (Index k = 0; k < n_; ++k) {
    near_.x.col(k) = at_a_.state->c + Q_a_ * (contact_.samples.X.col(reach_[k]) + u.segment<3>(3 * k));
    target.col(k) = Q_b_.transpose() * (near_.x.col(k) - at_b_.state->c);
    near_.Y.col(k) = feet_.col(reach_[k]);
  }
  draw_feet_to(target);
  const auto at = map_->points(near_.Y.leftCols(n_));
  near_.y.leftCols(n_) = at.x;
  for (Index k = 0; k < n_; ++k) {
    const Vector3d Y = near_.Y.col(k);
    if (Y != within_box(Y, most_scaled))
      throw std::runtime_error(
          "two bodies are close farther from where they first touched than the modes of the one that is met are known");
    feet_.col(reach_[k]) = Y;
    const Eigen::Matrix3d F = at.F.middleCols<3>(3 * k);
    const Vector3d normal = (F.inverse().transpose() * signed_distance(surface_.shape, Y).gradient).normalized();
    near_.gap[k] = normal.dot(target.col(k) - at.x.col(k));
    near_.n.col(k) = Q_b_ * normal;
    if (near_.gap_by_s.rows() == 0) continue;
    near_.gap_by_s.col(k).head(a_.n_static()).noalias() = near_.Psi.middleCols<3>(3 * k) * (turn_.transpose() * normal);
    near_.gap_by_s.col(k).tail(b_.n_static()).noalias() = -near_.Psi_b.middleCols<3>(3 * k) * normal;
  }
}

// Newton's steps of all feet at once, each until it hardly moves.
void BodyPair::draw_feet_to(const Matrix3Xd& target) {
  Matrix3Xd Y(3, n_);  // [m] of feet still sought
  std::vector<Index> sought(static_cast<size_t>(n_));
  std::iota(sought.begin(), sought.end(), Index{0});
  for (int round = 0; round < n_rounds && !sought.empty(); ++round) {
    Y.resize(3, std::ssize(sought));
    for (Index j = 0; j < Y.cols(); ++j) Y.col(j) = near_.Y.col(sought[static_cast<size_t>(j)]);
    const auto at = map_->points(Y);
    size_t n_left = 0;
    for (Index j = 0; j < Y.cols(); ++j) {
      const Index k = sought[static_cast<size_t>(j)];
      const Eigen::Matrix3d F = at.F.middleCols<3>(3 * j);
      near_.Y.col(k) = projected(surface_.shape, Y.col(j) + F.inverse() * (target.col(k) - at.x.col(j)));
      if (!((near_.Y.col(k) - Y.col(j)).squaredNorm() < still * still * surface_.radius * surface_.radius))
        sought[n_left++] = k;
    }
    sought.resize(n_left);
  }
}

void BodyPair::find_rates(const PolynomialMap& rate) {
  const VectorXd u = near_.Phi.leftCols(3 * n_).transpose() * *at_a_.rate;
  for (Index k = 0; k < n_; ++k) {
    const Vector3d own =
                       at_a_.state->v + at_a_.Omega.cross(near_.x.col(k) - at_a_.state->c) + Q_a_ * u.segment<3>(3 * k),
                   foot = at_b_.state->v + at_b_.Omega.cross(Q_b_ * near_.y.col(k)) +
                          Q_b_ * rate.displacement(near_.Y.col(k));
    near_.v.col(k) = own - foot;
  }
}

Vector3d BodyPair::in_partner(Index i) const {
  const BodyState &a = *at_a_.state, &b = *at_b_.state;
  Vector3d X = contact_.samples.X.col(i);
  X.noalias() += tables_->Phi.middleCols<3>(3 * i).transpose().lazyProduct(a.q);
  if (a.s.size() > 0) X.noalias() += tables_->Psi.middleCols<3>(3 * i).transpose().lazyProduct(a.s);
  Vector3d y = apart_ + turn_ * X;
  if (b.s.size() > 0) y.noalias() -= surface_.Psi.middleCols<3>(3 * i).transpose().lazyProduct(b.s);
  return y;
}

// Of distances of the shape at rest from where the points would be then.
double BodyPair::bound(const SampleTree::Extent& of) const {
  const Vector3d y = in_partner(of.sample), Y = within_box(projected(surface_.shape, y), 1);
  const Vector3d Z = y - map_->displacement(Y);
  double d;
  if (of.radius == 0) {
    d = signed_distance_value(surface_.shape, Z);
  } else {
    const Distance at = signed_distance(surface_.shape, Z);
    d = at.value + of.along(turn_.transpose() * at.gradient) - of.spread - strain_ * (of.radius + of.spread);
  }
  return d > 0 ? surely * d : d / surely;
}

Neighbours BodyPair::neighbours(const BodyState& a, const BodyState& b, const ListSize& size) {
  if (!is_finite(a) || !is_finite(b)) return {{}, {}, -1, 0};  // nothing presses in a state that is none
  VectorXd sizes(a.q.size() + a.s.size() + b.s.size());
  sizes << a.q.cwiseAbs(), a.s.cwiseAbs(), b.s.cwiseAbs();
  strain_ = std::min(1 - surely, map_->lipschitz_bound());
  return tree_->nearest([this](const SampleTree::Extent& of) { return bound(of); }, sizes, size);
}

BodyPair::Nearest BodyPair::nearest(const BodyState& a, const BodyState& b) {
  at_a_.state = &a, at_b_.state = &b;
  meet(a, b);
  const Neighbours one = neighbours(a, b, shortest());
  n_ = 0;
  if (one.order.empty()) return {std::numeric_limits<double>::quiet_NaN(), 0, Vector3d::Zero(), Vector3d::Zero()};
  const Index i = one.order.front();
  const Vector3d y = in_partner(i), Y = within_box(projected(surface_.shape, y), 1);
  return {one.gap.front(), i, Q_b_ * signed_distance(surface_.shape, y - map_->displacement(Y)).gradient, Y};
}

double BodyPair::shaking(const Nearest& at, const Moving& a, const Moving& b, double aside) const {
  const auto swing = [](const FloatingBody& body, const BodyState& state, const VectorXd& rate) {
    VectorXd all(body.n_modes());
    for (Index k = 0; k < all.size(); ++k) {
      const double lambda = body.modes[static_cast<size_t>(k)].k, rest = lambda > 0 ? body.weight[k] / lambda : 0;
      all[k] = std::hypot(rate[k], std::sqrt(lambda) * (state.q[k] - rest));
    }
    return all;
  };
  const VectorXd of_a = swing(a_, *a.state, *a.rate), of_b = swing(b_, *b.state, *b.rate);
  const Eigen::Matrix3d normal = at.normal * at.normal.transpose(),
                        weighted = normal + aside * (Eigen::Matrix3d::Identity() - normal);
  const Matrix3Xd by_a = weighted * Q_a_ * tables_->Phi.middleCols<3>(3 * at.sample).transpose() * of_a.asDiagonal(),
                  by_b = weighted * Q_b_ * surface_.geometry.at(at.Y) * of_b.asDiagonal();
  const auto most = [](const Matrix3Xd& by_mode) {  // 3 rms; no more than all modes at once
    return std::min(3 * by_mode.norm(), by_mode.colwise().norm().sum());
  };
  return most(by_a) + most(by_b);
}

double BodyPair::least_gap() const {
  return n_ == 0 ? std::numeric_limits<double>::infinity() : near_.gap.head(n_).minCoeff();
}

bool BodyPair::covers(const VectorXd& s) {
  const VectorXd s_b = s.tail(b_.n_static());
  return reach_.covers(s.head(a_.n_static()), &s_b);
}

}  // namespace mb
