#include "modal/contact/contact_step.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "modal/contact/turn.h"

namespace mb {

std::optional<ContactScheme> contact_scheme(const std::string& integrator) {
  if (integrator == "exact") return ContactScheme::exact;
  if (integrator == "symplectic-euler") return ContactScheme::symplectic_euler;
  if (integrator == "newmark") return ContactScheme::newmark;
  return std::nullopt;
}

ContactStepper::ContactStepper(const FloatingBody& body, ContactScheme scheme, double h)
    : body_(body), scheme_(scheme), h_(h), loads_(body) {
  if (!(h > 0 && std::isfinite(h))) throw std::invalid_argument("contact: the step must be positive and finite");
  if (body.coupling && scheme != ContactScheme::exact)
    throw std::invalid_argument("contact: of a body whose rotation and modes are coupled only 'exact' has steps");
  if (body.coupling) coupled_.emplace(body, h);
  const Index r = body.n_modes();
  for (VectorXd* x : {&lambda_, &c_, &C_, &S_, &C_dot_, &S_dot_, &P_, &scratch_}) x->resize(r);
  for (Index i = 0; i < r; ++i) {
    const Roots& mode = body.modes[static_cast<size_t>(i)];
    const Response x = response(mode, h);
    lambda_[i] = mode.k, c_[i] = 2 * mode.h;
    C_[i] = x.C, S_[i] = x.S, C_dot_[i] = x.C_dot, S_dot_[i] = x.S_dot, P_[i] = x.P;
  }
  inverse_inertia_ = body.free ? Eigen::Matrix3d(body.inertia.inverse()) : Eigen::Matrix3d::Zero();
}

void ContactStepper::touch(ContactState& state) {
  loads_.touch();
  has_before_ = false;
  look(state);
}

void ContactStepper::look(ContactState& state) {
  ++n_evaluations_;
  BodyState& b = state.body;
  if (!body_.coupling) return loads_(b, angular_velocity(body_, b), state.load);
  const Spin now = spin(body_, b);
  const VectorXd momenta = std::exchange(b.p, now.rate);  // contact feels velocities
  loads_(b, b.Q * now.Omega, state.load);
  b.p = momenta;
}

void ContactStepper::look_ahead(ContactState& state) {
  s_ = state.body.s;
  if (has_before_) state.body.s += s_ - s_before_;
  s_before_.swap(s_);
  has_before_ = true;
  look(state);
}

void ContactStepper::kick(ContactState& state, double tau) const {
  BodyState& b = state.body;
  if (body_.free) {
    b.v += (tau / body_.mass) * state.load.force;
    b.L += tau * state.load.torque;
  }
  b.p.noalias() += tau * state.load.modal;
  state.impulse += tau * state.load.force;
  state.dissipated += tau * state.load.dissipation;
}

// By the angular velocity half way, found from the momentum.
void ContactStepper::turn(BodyState& b, double tau) const {
  if (b.L.isZero(0)) return;
  const auto omega = [&](const Eigen::Quaterniond& Q) -> Vector3d {
    return Q * (inverse_inertia_ * (Q.conjugate() * b.L));
  };
  b.Q = turned(b.Q, tau * omega(turned(b.Q, tau / 2 * omega(b.Q))));
}

void ContactStepper::drift(BodyState& b) const {
  if (body_.free) {
    b.c += h_ * b.v + (h_ * h_ / 2) * body_.gravity;
    b.v += h_ * body_.gravity;
    if (coupled_) {
      b = coupled_->advance(std::move(b));
      return;
    }
    turn(b, h_);
  }
  const auto &q = b.q.array(), &p = b.p.array();
  auto next = (C_.array() * q + S_.array() * p + P_.array() * body_.weight.array()).eval();
  b.p = C_dot_.array() * q + S_dot_.array() * p + S_.array() * body_.weight.array();
  b.q = next;
}

bool ContactStepper::advance_exactly(ContactState& state) {
  kick(state, h_ / 2);
  drift(state.body);
  look_ahead(state);
  kick(state, h_ / 2);
  return state.load.converged;
}

bool ContactStepper::advance_by_euler(ContactState& state) {
  BodyState& b = state.body;
  b.p.array() += h_ * (body_.weight.array() - c_.array() * b.p.array() - lambda_.array() * b.q.array());
  kick(state, h_);
  b.q.noalias() += h_ * b.p;
  if (body_.free) {
    b.v += h_ * body_.gravity;
    b.c += h_ * b.v;
    turn(b, h_);
  }
  look_ahead(state);
  return state.load.converged;
}

bool ContactStepper::advance(ContactState& state) {
  loads_.begin_step(state.body.s, h_);
  switch (scheme_) {
    case ContactScheme::exact:
      return advance_exactly(state);
    case ContactScheme::symplectic_euler:
      return advance_by_euler(state);
    case ContactScheme::newmark:
      return advance_by_newmark(state);
  }
  throw std::logic_error("no such scheme");
}

}  // namespace mb
