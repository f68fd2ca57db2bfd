#include "modal/contact/contact_load.h"

#include <cmath>
#include <limits>

#include "modal/contact/contact_pair.h"

namespace mb {

namespace {

constexpr int max_iterations = 30, max_rounds = 10;
constexpr double balanced = 1e-10;  // [-] of the forces in the balance: far below the error of any step

}  // namespace

ContactLoads::ContactLoads(const FloatingBody& body) : body_(body), r_(body.n_static()), step_(body.n_static()) {
  for (const SampledContact& contact : body.contacts) {
    const bool flat = std::holds_alternative<HalfSpace>(contact.surface.shape) && !contact.law.friction;
    pairs_.push_back(flat ? flat_pair(body, contact) : general_pair(body, contact));
  }
}
ContactLoads::~ContactLoads() = default;
ContactLoads::ContactLoads(ContactLoads&&) noexcept = default;

void ContactLoads::begin_step(const VectorXd& s, double h) {
  if (body_.static_damping == 0) return;
  n_past_ = n_past_ > 0 && h == h_ ? 2 : 1;
  long_before_ = before_;
  before_ = s;
  h_ = h;
}

VectorXd ContactLoads::past() const {
  if (n_past_ == 0) return VectorXd::Zero(body_.n_static());
  return n_past_ == 1 ? VectorXd(before_ / h_) : VectorXd((2 * before_ - 0.5 * long_before_) / h_);
}

// Newton's method; where a step does not lessen the imbalance, half of it.
bool ContactLoads::balance(VectorXd& s) {
  const double beta = body_.static_damping, slope = 1 + beta * by_s();
  const VectorXd carried = beta * past();
  const auto imbalance = [&] {
    r_.setZero();
    H_ = slope * body_.static_stiffness;
    for (const auto& pair : pairs_) pair->push(s, r_, H_);
    const double size = std::max(r_.norm(), slope * (body_.static_stiffness * s).norm());
    r_.noalias() -= body_.static_stiffness * (slope * s - carried);
    return std::pair(r_.norm(), size);
  };
  auto [off, size] = imbalance();
  const double at_first = off;  // without forces s goes to zero, and `size` is of no use
  for (int i = 0; i < max_iterations; ++i) {
    if (!std::isfinite(off)) return false;
    if (off <= balanced * std::max(size, at_first)) return true;
    step_ = factor_.compute(H_).solve(r_);
    for (int halving = 0; halving < 10; ++halving, step_ /= 2) {
      s += step_;
      const auto [off_next, size_next] = imbalance();
      if (off_next < off || halving == 9) {
        off = off_next, size = size_next;
        break;
      }
      s -= step_;
    }
  }
  return false;
}

// Static shapes may bring more samples to the obstacle than were looked at: then once more, from where they came to.
bool ContactLoads::settle(BodyState& state, const Vector3d& Omega) {
  for (int round = 0; round < max_rounds; ++round) {
    for (const auto& pair : pairs_) pair->look(state, Omega);
    if (body_.n_static() == 0) return true;
    if (!balance(state.s)) return false;
    bool covered = true;
    for (const auto& pair : pairs_) covered = pair->covers(state.s) && covered;
    if (covered) return true;
  }
  return false;
}

void ContactLoads::operator()(BodyState& state, const Vector3d& Omega, ContactLoad& load) {
  load = {Vector3d::Zero(),
          Vector3d::Zero(),
          std::move(load.modal),
          std::numeric_limits<double>::infinity(),
          0,
          0,
          0,
          true};
  load.modal.setZero(body_.n_modes());
  load.converged = settle(state, Omega);
  if (body_.n_static() > 0) {
    const VectorXd rate = by_s() * state.s - past();
    load.stored += 0.5 * state.s.dot(body_.static_stiffness * state.s);
    load.dissipation += body_.static_damping * rate.dot(body_.static_stiffness * rate);
  }
  for (const auto& pair : pairs_) pair->act(state.s, load);
}

MatrixXd ContactLoads::stiffness(const VectorXd& s, double rate) {
  const Index n = (body_.free ? 6 : 0) + body_.n_modes(), n_s = body_.n_static();
  MatrixXd K = MatrixXd::Zero(n + n_s, n + n_s);
  K.bottomRightCorner(n_s, n_s) = (1 + body_.static_damping * by_s()) * body_.static_stiffness;
  for (const auto& pair : pairs_) pair->stiffen(s, rate, K);
  if (n_s == 0) return K;
  const MatrixXd follow = K.bottomRightCorner(n_s, n_s).partialPivLu().solve(K.bottomLeftCorner(n_s, n));
  return K.topLeftCorner(n, n) - K.topRightCorner(n, n_s) * follow;
}

}  // namespace mb
