#include "modal/contact/body_pair.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "mechanics/geometry/signed_distance.h"
#include "modal/contact/sample_tables.h"

namespace mb {

namespace {

constexpr int n_rounds = 2;          // of a foot at most; each leaves the strain's part of the error
constexpr double still = 1e-4;       // [-] of the size: a foot that moves no farther is found, to second order
constexpr double surely = 0.8;       // [-] of a distance at rest, of what is far: no strain takes more
constexpr double most_scaled = 1.1;  // [-] of a foot, by the box in which the modes are known
constexpr double far = 1.5;          // [-] by the largest displacements: what is left is near the distance

// Of theta -> theta x arm.
Eigen::Matrix3d turning(const Vector3d& arm) {
  return (Eigen::Matrix3d() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0).finished();
}

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
      Phi_(tables_->Phi),
      Psi_(tables_->Psi),
      Psi_b_(surface_.Psi),
      feet_(surface_.feet) {}

void BodyPair::look(const Moving& a, const Moving& b) {
  at_a_ = a, at_b_ = b;
  Q_a_ = a.state->Q.toRotationMatrix(), Q_b_ = b.state->Q.toRotationMatrix();
  map_.emplace(surface_.geometry.map(b.state->q));
  rate_.emplace(surface_.geometry.map(*b.rate));
  n_ = reach_.n_reachable(
      *a.state, [&] { return gaps(); }, b.state);
  near_.resize(static_cast<size_t>(n_));
  for (Index k = 0; k < n_; ++k) {
    const Index i = reach_[k];
    Near& near = near_[static_cast<size_t>(k)];
    const auto Phi = Phi_.middleCols(3 * i, 3);
    const Vector3d arm = Q_a_ * (contact_.samples.X.col(i) + Phi.transpose() * a.state->q);
    near.x = a.state->c + arm;
    find_foot(i, near);
    feet_.col(i) = near.Y;
    const Vector3d own = a.state->v + a.Omega.cross(arm) + Q_a_ * (Phi.transpose() * *a.rate);
    near.v = own - (b.state->v + b.Omega.cross(Q_b_ * near.y) + Q_b_ * rate_->displacement(near.Y));
  }
  clearance_ = std::min(least_gap(), reach_.beyond(*a.state, b.state));
}

// The nearest to Y of the box in which the modes of b are known, made larger by a factor: beyond it polynomials mean
// nothing.
Vector3d BodyPair::within_box(const Vector3d& Y, double larger) const {
  const Monomials& m = surface_.geometry.monomials();
  const Vector3d xi = m.scaled(Y);
  if ((xi.array().abs() <= larger).all()) return Y;
  return m.centre() + m.half_extents().cwiseProduct(xi.cwiseMax(-larger).cwiseMin(larger));
}

void BodyPair::find_foot(Index i, Near& near) const {
  const Vector3d y = Q_b_.transpose() * (near.x - at_b_.state->c);
  near.Y = feet_.col(i);
  for (int round = 0; round < n_rounds; ++round) {
    const auto at = map_->at(near.Y);
    const Vector3d before = near.Y;
    near.Y = projected(surface_.shape, near.Y + at.F.inverse() * (y - at.x));
    if ((near.Y - before).squaredNorm() < still * still * surface_.radius * surface_.radius) break;
  }
  if (near.Y != within_box(near.Y, most_scaled))
    throw std::runtime_error(
        "two bodies are close farther from where they first touched than the modes of the one that is met are known");
  const auto at = map_->at(near.Y);
  near.y = at.x;
  const Vector3d n = at.F.inverse().transpose() * signed_distance(surface_.shape, near.Y).gradient;
  const Vector3d normal = n.normalized();
  near.gap = normal.dot(y - at.x);
  near.n = Q_b_ * normal;
}

// Lower bounds of what is far: of both at rest less all that strains can do; else by distances of the shape at rest
// from where the points would be then.
VectorXd BodyPair::gaps() const {
  VectorXd all(contact_.samples.w.size());
  const auto most = [](const auto& of, const BodyState& state) {
    return of.largest_q.dot(state.q.cwiseAbs()) + of.largest_s.dot(state.s.cwiseAbs());
  };
  const double loose = most(*tables_, *at_a_.state) + most(surface_, *at_b_.state);
  const Eigen::Matrix3d turn = Q_b_.transpose() * Q_a_;
  const Vector3d apart = Q_b_.transpose() * (at_a_.state->c - at_b_.state->c);
  for (Index i = 0; i < all.size(); ++i) {
    const double at_rest = signed_distance_value(surface_.shape, apart + turn * contact_.samples.X.col(i));
    if (at_rest > far * loose) {
      all[i] = at_rest - loose;
      continue;
    }
    const Vector3d u =
        Phi_.middleCols(3 * i, 3).transpose() * at_a_.state->q + Psi_.middleCols(3 * i, 3).transpose() * at_a_.state->s;
    const Vector3d x = at_a_.state->c + Q_a_ * (contact_.samples.X.col(i) + u);
    const Vector3d y = Q_b_.transpose() * (x - at_b_.state->c);
    const Vector3d Y = within_box(projected(surface_.shape, y), 1);
    const double d = signed_distance_value(surface_.shape, y - map_->displacement(Y));
    all[i] = d > 0 ? surely * d : d / surely;
  }
  return all;
}

double BodyPair::least_gap() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Near& near : near_) least = std::min(least, near.gap);
  return least;
}

double BodyPair::shaking(const Moving& a, const Moving& b) const {
  const auto swing = [](const FloatingBody& body, const BodyState& state, const VectorXd& rate) {
    VectorXd all(body.n_modes());
    for (Index k = 0; k < all.size(); ++k) {
      const double lambda = body.modes[static_cast<size_t>(k)].k, rest = lambda > 0 ? body.weight[k] / lambda : 0;
      all[k] = std::hypot(rate[k], std::sqrt(lambda) * (state.q[k] - rest));
    }
    return all;
  };
  const Index i = reach_[0];
  const VectorXd of_a = swing(a_, *a.state, *a.rate), of_b = swing(b_, *b.state, *b.rate);
  const MatrixXd Phi_b = surface_.geometry.at(feet_.col(i));
  return 3 * ((Phi_.middleCols(3 * i, 3).transpose() * of_a.asDiagonal()).norm() + (Phi_b * of_b.asDiagonal()).norm());
}

Eigen::Matrix<double, 3, Eigen::Dynamic> BodyPair::rows(Index i) const {
  Eigen::Matrix<double, 3, Eigen::Dynamic> all(3, a_.n_static() + b_.n_static());
  all.leftCols(a_.n_static()).noalias() = Q_a_ * Psi_.middleCols(3 * i, 3).transpose();
  all.rightCols(b_.n_static()).noalias() = -Q_b_ * Psi_b_.middleCols(3 * i, 3).transpose();
  return all;
}

std::optional<BodyPair::Pressing> BodyPair::press(Index k, const VectorXd& s) const {
  const Near& near = near_[static_cast<size_t>(k)];
  const Index i = reach_[k], n_a = a_.n_static();
  Vector3d moved = Vector3d::Zero(), own = Vector3d::Zero();
  if (s.size() > 0) {
    own = Q_a_ * (Psi_.middleCols(3 * i, 3).transpose() * s.head(n_a));
    moved = own - Q_b_ * (Psi_b_.middleCols(3 * i, 3).transpose() * s.tail(s.size() - n_a));
  }
  const double value = near.gap + near.n.dot(moved);
  if (!(value < 0)) return Pressing{value, near.x + own, {}};
  return Pressing{value, near.x + own,
                  contact_traction(contact_.law, {value, near.n, Eigen::Matrix3d::Zero()}, near.v)};
}

void BodyPair::push(const VectorXd& s, VectorXd& f_s, MatrixXd& H) {
  for (Index k = 0; k < n_; ++k) {
    const Index i = reach_[k];
    const auto pressing = press(k, s);
    if (!(pressing->value < 0)) continue;
    const auto R = rows(i);
    const double w = contact_.samples.w[i];
    f_s.noalias() += w * (R.transpose() * pressing->t.t);
    H.noalias() -= w * (R.transpose() * pressing->t.by_x * R);
  }
}

bool BodyPair::covers(const VectorXd& s) {
  const VectorXd s_b = s.tail(b_.n_static());
  return reach_.covers(s.head(a_.n_static()), &s_b);
}

void BodyPair::act(const VectorXd& s, ContactLoad& a, ContactLoad& b) {
  std::vector<Index> pressed;
  std::vector<Vector3d> forces;
  for (Index k = 0; k < n_; ++k) {
    const Index i = reach_[k];
    const Near& near = near_[static_cast<size_t>(k)];
    const auto [value, x, t] = *press(k, s);
    a.least_gap = std::min(a.least_gap, value);
    if (!(value < 0)) continue;
    const double w = contact_.samples.w[i];
    const Vector3d f = w * t.t;
    a.force += f;
    a.torque += (x - at_a_.state->c).cross(f);
    a.modal.noalias() += Phi_.middleCols(3 * i, 3) * (Q_a_.transpose() * f);
    a.stored += w * stored_energy(contact_.law, value);
    a.dissipation -= f.dot(near.v) - w * layer(contact_.law, value).pressure * near.n.dot(near.v);
    b.force -= f;
    b.torque -= (x - at_b_.state->c).cross(f);
    pressed.push_back(k);
    forces.push_back(-(Q_b_.transpose() * f));
  }
  b.least_gap = std::min(b.least_gap, a.least_gap);
  a.n_visited += n_;
  reach_.pressed(std::ssize(pressed));
  if (pressed.empty()) return;
  Matrix3Xd Y(3, std::ssize(pressed)), f(3, std::ssize(pressed));
  for (size_t k = 0; k < pressed.size(); ++k) {
    Y.col(static_cast<Index>(k)) = near_[static_cast<size_t>(pressed[k])].Y;
    f.col(static_cast<Index>(k)) = forces[k];
  }
  const MatrixXd moments = f * surface_.geometry.monomials().values(Y);  // 3 x monomials
  b.modal.noalias() += surface_.geometry.coefficients().transpose() * moments.reshaped();
}

void BodyPair::stiffen(const VectorXd& s, double rate, MatrixXd& K) {
  const Index f_a = a_.free ? 6 : 0, f_b = b_.free ? 6 : 0, r_a = a_.n_modes(), r_b = b_.n_modes();
  MatrixXd G(3, K.rows());
  for (Index k = 0; k < n_; ++k) {
    const Index i = reach_[k];
    const Near& near = near_[static_cast<size_t>(k)];
    const auto [value, x, t] = *press(k, s);
    if (!(value < 0)) continue;
    if (a_.free) G.leftCols<3>().setIdentity(), G.middleCols<3>(3) = turning(x - at_a_.state->c);
    G.middleCols(f_a, r_a) = Q_a_ * Phi_.middleCols(3 * i, 3).transpose();
    const Index at_b = f_a + r_a;
    if (b_.free)
      G.middleCols<3>(at_b) = -Eigen::Matrix3d::Identity(), G.middleCols<3>(at_b + 3) = -turning(Q_b_ * near.y);
    G.middleCols(at_b + f_b, r_b) = -Q_b_ * surface_.geometry.at(near.Y);
    G.rightCols(s.size()) = rows(i);
    MatrixXd G_rate = G;  // that of static shapes is left out
    G_rate.rightCols(s.size()).setZero();
    K.noalias() -= contact_.samples.w[i] * G.transpose() * (t.by_x * G + rate * t.by_v * G_rate);
  }
}

}  // namespace mb
