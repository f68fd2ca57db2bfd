#include "modal/contact/contact_step.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "modal/frame/turn.h"

namespace mb {

std::optional<ContactScheme> contact_scheme(const std::string& integrator) {
  if (integrator == "exact") return ContactScheme::exact;
  if (integrator == "symplectic-euler") return ContactScheme::symplectic_euler;
  if (integrator == "central-difference") return ContactScheme::central_difference;
  if (integrator == "explicit-euler") return ContactScheme::explicit_euler;
  if (integrator == "newmark") return ContactScheme::newmark;
  return std::nullopt;
}

ContactStepper::OfBody::OfBody(const FloatingBody& of, double h) : body(&of) {
  if (of.coupling) coupled.emplace(of, h);
  const Index r = of.n_modes();
  for (VectorXd* x : {&lambda, &c, &C, &S, &C_dot, &S_dot, &P}) x->resize(r);
  for (Index i = 0; i < r; ++i) {
    const Roots& mode = of.modes[static_cast<size_t>(i)];
    const Response x = response(mode, h);
    lambda[i] = mode.k, c[i] = 2 * mode.h;
    C[i] = x.C, S[i] = x.S, C_dot[i] = x.C_dot, S_dot[i] = x.S_dot, P[i] = x.P;
  }
  inverse_inertia = of.free ? Eigen::Matrix3d(of.inertia.inverse()) : Eigen::Matrix3d::Zero();
}

ContactStepper::ContactStepper(const std::vector<const FloatingBody*>& bodies, ContactScheme scheme, double h)
    : scheme_(scheme), h_(h), loads_(bodies) {
  if (!(h > 0 && std::isfinite(h))) throw std::invalid_argument("contact: the step must be positive and finite");
  for (const FloatingBody* body : bodies) {
    if (body->coupling && scheme != ContactScheme::exact)
      throw std::invalid_argument("contact: of a body whose rotation and modes are coupled only 'exact' has steps");
    bodies_.emplace_back(*body, h);
  }
}

void ContactStepper::touch(std::span<ContactState> states) {
  loads_.touch();
  has_before_ = false;
  look(states);
}

void ContactStepper::look(std::span<ContactState> states) {
  ++n_evaluations_;
  std::vector<Looked> looked;
  std::vector<VectorXd> of_coupled(states.size());  // q', where it is no state's own
  for (size_t b = 0; b < states.size(); ++b) {
    BodyState& state = states[b].body;
    const FloatingBody& body = *bodies_[b].body;
    if (body.coupling) {
      Spin now = spin(body, state);
      of_coupled[b] = std::move(now.rate);
      looked.push_back({&state, state.Q * now.Omega, &of_coupled[b], &states[b].load});
    } else {
      looked.push_back({&state, angular_velocity(body, state), &state.p, &states[b].load});
    }
  }
  loads_(looked);
}

VectorXd static_shapes(std::span<const ContactState> states) {
  Index n = 0;
  for (const ContactState& state : states) n += state.body.s.size();
  VectorXd all(n);
  n = 0;
  for (const ContactState& state : states) {
    all.segment(n, state.body.s.size()) = state.body.s;
    n += state.body.s.size();
  }
  return all;
}

bool ContactStepper::converged(std::span<const ContactState> states) { return states.front().load.converged; }

void ContactStepper::look_ahead(std::span<ContactState> states) {
  s_ = static_shapes(states);
  if (has_before_) {
    Index n = 0;
    for (ContactState& state : states) {
      VectorXd& s = state.body.s;
      s += s_.segment(n, s.size()) - s_before_.segment(n, s.size());
      n += s.size();
    }
  }
  s_before_.swap(s_);
  has_before_ = true;
  look(states);
}

void ContactStepper::OfBody::kick(ContactState& state, double tau) const {
  BodyState& b = state.body;
  if (body->free) {
    b.v += (tau / body->mass) * state.load.force;
    b.L += tau * state.load.torque;
  }
  b.p.noalias() += tau * state.load.modal;
  state.impulse += tau * state.load.force;
  state.dissipated += tau * state.load.dissipation;
}

// By the angular velocity half way, found from the momentum.
void ContactStepper::OfBody::turn(BodyState& b, double tau) const {
  if (b.L.isZero(0)) return;
  const auto omega = [&](const Eigen::Quaterniond& Q) -> Vector3d {
    return Q * (inverse_inertia * (Q.conjugate() * b.L));
  };
  b.Q = turned(b.Q, tau * omega(turned(b.Q, tau / 2 * omega(b.Q))));
}

void ContactStepper::OfBody::drift(BodyState& b, double h) const {
  if (body->free) {
    b.c += h * b.v + (h * h / 2) * body->gravity;
    b.v += h * body->gravity;
    if (coupled) {
      b = coupled->advance(std::move(b));
      return;
    }
    turn(b, h);
  }
  const auto &q = b.q.array(), &p = b.p.array();
  auto next = (C.array() * q + S.array() * p + P.array() * body->weight.array()).eval();
  b.p = C_dot.array() * q + S_dot.array() * p + S.array() * body->weight.array();
  b.q = next;
}

void ContactStepper::OfBody::kick_freely(BodyState& b, double tau, double damped) const {
  b.p.array() += tau * (body->weight.array() - lambda.array() * b.q.array() - damped * c.array() * b.p.array());
  if (body->free) b.v += tau * body->gravity;
}

void ContactStepper::OfBody::move(BodyState& b, double tau) const {
  b.q.noalias() += tau * b.p;
  if (!body->free) return;
  b.c += tau * b.v;
  turn(b, tau);
}

bool ContactStepper::advance_exactly(std::span<ContactState> states) {
  for (size_t i = 0; i < states.size(); ++i) {
    bodies_[i].kick(states[i], h_ / 2);
    bodies_[i].drift(states[i].body, h_);
  }
  look_ahead(states);
  for (size_t i = 0; i < states.size(); ++i) bodies_[i].kick(states[i], h_ / 2);
  return converged(states);
}

bool ContactStepper::advance_by_euler(std::span<ContactState> states) {
  for (size_t i = 0; i < states.size(); ++i) {
    bodies_[i].kick_freely(states[i].body, h_, 1);
    bodies_[i].kick(states[i], h_);
    bodies_[i].move(states[i].body, h_);
  }
  look_ahead(states);
  return converged(states);
}

bool ContactStepper::advance_by_explicit_euler(std::span<ContactState> states) {
  for (size_t i = 0; i < states.size(); ++i) {
    BodyState moved = states[i].body;
    bodies_[i].move(moved, h_);
    bodies_[i].kick_freely(states[i].body, h_, 1);
    bodies_[i].kick(states[i], h_);
    BodyState& b = states[i].body;
    b.q = moved.q, b.c = moved.c, b.Q = moved.Q;
  }
  look_ahead(states);
  return converged(states);
}

bool ContactStepper::advance_by_central_differences(std::span<ContactState> states) {
  for (size_t i = 0; i < states.size(); ++i) {
    bodies_[i].kick_freely(states[i].body, h_ / 2, 1);
    bodies_[i].kick(states[i], h_ / 2);
    bodies_[i].move(states[i].body, h_);
  }
  look_ahead(states);
  for (size_t i = 0; i < states.size(); ++i) {
    BodyState& b = states[i].body;
    bodies_[i].kick_freely(b, h_ / 2, 0);
    bodies_[i].kick(states[i], h_ / 2);
    b.p.array() /= 1 + h_ / 2 * bodies_[i].c.array();
  }
  return converged(states);
}

bool ContactStepper::advance(std::span<ContactState> states) {
  loads_.begin_step(static_shapes(states), h_);
  switch (scheme_) {
    case ContactScheme::exact:
      return advance_exactly(states);
    case ContactScheme::symplectic_euler:
      return advance_by_euler(states);
    case ContactScheme::central_difference:
      return advance_by_central_differences(states);
    case ContactScheme::explicit_euler:
      return advance_by_explicit_euler(states);
    case ContactScheme::newmark:
      return advance_by_newmark(states);
  }
  throw std::logic_error("no such scheme");
}

}  // namespace mb
