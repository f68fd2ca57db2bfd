#include "modal/contact/contact_load.h"

#include <cmath>
#include <limits>

#include "modal/contact/body_pair.h"
#include "modal/contact/sampled_pair.h"

namespace mb {

namespace {

constexpr int max_iterations = 30, max_rounds = 10;
constexpr double balanced = 1e-10;  // [-] of forces or of shapes: far below the error of any step

}  // namespace

ContactLoads::ContactLoads(std::vector<const FloatingBody*> bodies) : bodies_(std::move(bodies)) {
  for (const FloatingBody* body : bodies_) {
    places_.push_back({n_z_, (body->free ? 6 : 0) + body->n_modes(), n_s_, body->n_static()});
    n_z_ += places_.back().n_z, n_s_ += places_.back().n_s;
  }
  for (VectorXd* x : {&r_, &step_, &s_, &beta_}) x->setZero(n_s_);
  static_stiffness_.setZero(n_s_, n_s_);
  for (size_t b = 0; b < bodies_.size(); ++b) {
    const Place& at = places_[b];
    static_stiffness_.block(at.s, at.s, at.n_s, at.n_s) = bodies_[b]->static_stiffness;
    beta_.segment(at.s, at.n_s).setConstant(bodies_[b]->static_damping);
    for (const SampledContact& contact : bodies_[b]->contacts) {
      if (contact.partner) {
        const size_t other = contact.partner->body;
        between_.push_back({b, other, std::make_unique<BodyPair>(*bodies_[b], *bodies_.at(other), contact)});
        continue;
      }
      const bool flat = std::holds_alternative<HalfSpace>(contact.surface.shape) && !contact.law.friction;
      pairs_.push_back({b, flat ? flat_pair(*bodies_[b], contact) : general_pair(*bodies_[b], contact)});
    }
  }
}
ContactLoads::~ContactLoads() = default;
ContactLoads::ContactLoads(ContactLoads&&) noexcept = default;

void ContactLoads::begin_step(const VectorXd& s, double h) {
  if (beta_.isZero(0)) return;
  n_past_ = n_past_ > 0 && h == h_ ? 2 : 1;
  long_before_ = before_;
  before_ = s;
  h_ = h;
}

VectorXd ContactLoads::past() const {
  if (n_past_ == 0) return VectorXd::Zero(n_s_);
  return n_past_ == 1 ? VectorXd(before_ / h_) : VectorXd((2 * before_ - 0.5 * long_before_) / h_);
}

// Frames and modes of a and b, their static shapes.
std::vector<Index> ContactLoads::unknowns(const OfTwo& of) const {
  std::vector<Index> all;
  for (const size_t b : {of.a, of.b})
    for (Index i = 0; i < places_[b].n_z; ++i) all.push_back(places_[b].z + i);
  for (const size_t b : {of.a, of.b})
    for (Index i = 0; i < places_[b].n_s; ++i) all.push_back(n_z_ + places_[b].s + i);
  return all;
}

VectorXd ContactLoads::of_both(const VectorXd& s, const OfTwo& of) const {
  VectorXd both(places_[of.a].n_s + places_[of.b].n_s);
  both << own(s, of.a), own(s, of.b);
  return both;
}

void ContactLoads::push(const VectorXd& s) {
  if (bodies_.size() == 1) {
    for (const OfBody& of : pairs_) of.pair->push(s, r_, H_);
    return;
  }
  VectorXd r;
  MatrixXd H;
  for (const OfBody& of : pairs_) {
    const Place& at = places_[of.body];
    r.setZero(at.n_s), H.setZero(at.n_s, at.n_s);
    of.pair->push(own(s, of.body), r, H);
    r_.segment(at.s, at.n_s) += r;
    H_.block(at.s, at.s, at.n_s, at.n_s) += H;
  }
  for (const OfTwo& of : between_) {
    const Index n_a = places_[of.a].n_s, n = n_a + places_[of.b].n_s;
    const auto at = [&](Index i) { return i < n_a ? places_[of.a].s + i : places_[of.b].s + i - n_a; };
    r.setZero(n), H.setZero(n, n);
    of.pair->push(of_both(s, of), r, H);
    for (Index i = 0; i < n; ++i) {
      r_[at(i)] += r[i];
      for (Index j = 0; j < n; ++j) H_(at(i), at(j)) += H(i, j);
    }
  }
}

// Newton's method; where a step does not lessen the imbalance, half of it. Balanced, too, where a step that is next to
// nothing of s leaves more than half of the imbalance: that is rounding of places in a stiff layer, k w eps |x|.
bool ContactLoads::balance(VectorXd& s) {
  const VectorXd slope = 1 + by_s() * beta_.array(), carried = beta_.cwiseProduct(past());
  const auto imbalance = [&] {
    r_.setZero();
    H_.noalias() = static_stiffness_ * slope.asDiagonal();
    push(s);
    const double size = std::max(r_.norm(), (static_stiffness_ * slope.cwiseProduct(s)).norm());
    r_.noalias() -= static_stiffness_ * (slope.cwiseProduct(s) - carried);
    return std::pair(r_.norm(), size);
  };
  auto [off, size] = imbalance();
  const double at_first = off;  // without forces s goes to zero, and `size` is of no use
  for (int i = 0; i < max_iterations; ++i) {
    if (!std::isfinite(off)) return false;
    if (off <= balanced * std::max(size, at_first)) return true;
    step_ = factor_.compute(H_).solve(r_);
    const bool next_to_nothing = step_.norm() <= balanced * s.norm();
    for (int halving = 0; halving < 10; ++halving, step_ /= 2) {
      s += step_;
      const auto [off_next, size_next] = imbalance();
      if (next_to_nothing && !(off_next < off / 2)) return true;
      if (off_next < off || halving == 9) {
        off = off_next, size = size_next;
        break;
      }
      s -= step_;
    }
  }
  return false;
}

void ContactLoads::look(std::span<const Looked> bodies) {
  for (const OfBody& of : pairs_) of.pair->look(*bodies[of.body].state, bodies[of.body].Omega, *bodies[of.body].rate);
  const auto moving = [&](size_t b) { return BodyPair::Moving{bodies[b].state, bodies[b].Omega, bodies[b].rate}; };
  for (const OfTwo& of : between_) of.pair->look(moving(of.a), moving(of.b));
}

bool ContactLoads::covers(const VectorXd& s) {
  bool covered = true;
  for (const OfBody& of : pairs_) covered = of.pair->covers(own(s, of.body)) && covered;
  for (const OfTwo& of : between_) covered = of.pair->covers(of_both(s, of)) && covered;
  return covered;
}

// Static shapes may bring more samples to the obstacle than were looked at: then once more, from where they came to.
bool ContactLoads::settle(std::span<const Looked> bodies) {
  for (int round = 0; round < max_rounds; ++round) {
    look(bodies);
    if (n_s_ == 0) return true;
    for (size_t b = 0; b < bodies.size(); ++b) s_.segment(places_[b].s, places_[b].n_s) = bodies[b].state->s;
    const bool found = balance(s_);
    for (size_t b = 0; b < bodies.size(); ++b) bodies[b].state->s = own(s_, b);
    if (!found) return false;
    if (covers(s_)) return true;
  }
  return false;
}

void ContactLoads::operator()(std::span<const Looked> bodies) {
  for (size_t b = 0; b < bodies.size(); ++b) {
    ContactLoad& load = *bodies[b].load;
    load = {Vector3d::Zero(),
            Vector3d::Zero(),
            std::move(load.modal),
            std::numeric_limits<double>::infinity(),
            0,
            0,
            0,
            true};
    load.modal.setZero(bodies_[b]->n_modes());
  }
  const bool converged = settle(bodies);
  const VectorXd rate = n_s_ > 0 ? VectorXd(by_s() * s_ - past()) : VectorXd();
  for (size_t b = 0; b < bodies.size(); ++b) {
    const FloatingBody& body = *bodies_[b];
    ContactLoad& load = *bodies[b].load;
    load.converged = converged;
    if (body.n_static() == 0) continue;
    const VectorXd &s = bodies[b].state->s, own_rate = own(rate, b);
    load.stored += 0.5 * s.dot(body.static_stiffness * s);
    load.dissipation += body.static_damping * own_rate.dot(body.static_stiffness * own_rate);
  }
  for (const OfBody& of : pairs_) of.pair->act(bodies[of.body].state->s, *bodies[of.body].load);
  for (const OfTwo& of : between_) of.pair->act(of_both(s_, of), *bodies[of.a].load, *bodies[of.b].load);
}

MatrixXd ContactLoads::stiffness(const VectorXd& s, double rate) {
  MatrixXd K = MatrixXd::Zero(n_z_ + n_s_, n_z_ + n_s_), part;
  K.bottomRightCorner(n_s_, n_s_) = static_stiffness_ * (1 + by_s() * beta_.array()).matrix().asDiagonal();
  const auto add = [&](const std::vector<Index>& at, const auto& stiffen) {
    part.setZero(std::ssize(at), std::ssize(at));
    stiffen();
    for (size_t i = 0; i < at.size(); ++i)
      for (size_t j = 0; j < at.size(); ++j) K(at[i], at[j]) += part(static_cast<Index>(i), static_cast<Index>(j));
  };
  for (const OfBody& of : pairs_) {
    const Place& here = places_[of.body];
    std::vector<Index> at;
    for (Index i = 0; i < here.n_z; ++i) at.push_back(here.z + i);
    for (Index i = 0; i < here.n_s; ++i) at.push_back(n_z_ + here.s + i);
    add(at, [&] { of.pair->stiffen(own(s, of.body), rate, part); });
  }
  for (const OfTwo& of : between_) add(unknowns(of), [&] { of.pair->stiffen(of_both(s, of), rate, part); });
  if (n_s_ == 0) return K;
  const MatrixXd follow = K.bottomRightCorner(n_s_, n_s_).partialPivLu().solve(K.bottomLeftCorner(n_s_, n_z_));
  return K.topLeftCorner(n_z_, n_z_) - K.topRightCorner(n_z_, n_s_) * follow;
}

}  // namespace mb
