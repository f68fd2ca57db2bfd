// Average acceleration with contact at the step's end, in the rates y = (v, Omega, p):
//
//   z1 = z0 + h/2 (y0 + y1),    M(Q1) y1 - M(Q0) y0 = h/2 (f0 + f1),    f = (F + m g, T, Phi^T F + weight - c p - l q)
#include <cmath>
#include <limits>

#include "modal/contact/contact_step.h"
#include "modal/contact/turn.h"

namespace mb {

namespace {

constexpr int max_iterations = 30, max_halvings = 8;
constexpr double tolerance = 1e-10;  // [-] of the momenta in play: far below the error of any step

}  // namespace

bool ContactStepper::advance_by_newmark(ContactState& state) {
  const Index n_frame = body_.free ? 6 : 0, r = body_.n_modes(), n = n_frame + r;
  const BodyState start = state.body;
  const Vector3d impulse = state.impulse, force_before = state.load.force;
  const double dissipated = state.dissipated, dissipation_before = state.load.dissipation;
  VectorXd y0(n), momentum0(n), mass(n), f(n);
  const auto forces = [&] {
    if (body_.free) f.head<6>() << state.load.force + body_.mass * body_.gravity, state.load.torque;
    f.tail(r) = state.load.modal + body_.weight - c_.cwiseProduct(state.body.p) - lambda_.cwiseProduct(state.body.q);
  };
  if (body_.free) {
    y0.head<6>() << start.v, angular_velocity(body_, start);
    momentum0.head<6>() << body_.mass * start.v, start.L;
    mass.head<6>() << Vector3d::Constant(body_.mass), body_.inertia.diagonal();
  }
  y0.tail(r) = momentum0.tail(r) = start.p;
  mass.tail(r).setOnes();
  forces();
  const VectorXd f0 = f;
  const auto size = [&](const VectorXd& x) {
    return std::isfinite(x.sum()) ? std::sqrt((x.array().square() / mass.array()).sum())
                                  : std::numeric_limits<double>::infinity();
  };
  // Puts the end of the step for rates y into `state`; the imbalance of momentum.
  const auto imbalance = [&](const VectorXd& y) {
    BodyState& b = state.body;
    VectorXd momentum(n);
    b.q = start.q + h_ / 2 * (start.p + y.tail(r));
    b.p = momentum.tail(r) = y.tail(r);
    if (body_.free) {
      b.c = start.c + h_ / 2 * (start.v + y.head<3>());
      b.v = y.head<3>();
      b.Q = turned(start.Q, h_ / 2 * (y0.segment<3>(3) + y.segment<3>(3)));
      b.L = b.Q * (body_.inertia * (b.Q.conjugate() * y.segment<3>(3)));
      momentum.head<6>() << body_.mass * b.v, b.L;
    }
    look(state);
    forces();
    return VectorXd(momentum - momentum0 - h_ / 2 * (f0 + f));
  };
  VectorXd y = y0, residual = imbalance(y);
  for (int i = 0; size(residual) > tolerance * (size(momentum0) + h_ * size(f0) + h_ * size(f)); ++i) {
    if (i == max_iterations || !std::isfinite(size(residual)) || !state.load.converged) return false;
    MatrixXd jacobian = h_ * h_ / 4 * loads_.stiffness(state.body.s, 2 / h_);
    jacobian.diagonal().tail(r).array() += 1 + h_ / 2 * c_.array() + h_ * h_ / 4 * lambda_.array();
    if (body_.free) {
      const Eigen::Matrix3d Q = state.body.Q.toRotationMatrix();
      jacobian.diagonal().head<3>().array() += body_.mass;
      jacobian.block<3, 3>(3, 3) += Q * body_.inertia * Q.transpose();
    }
    const VectorXd step = jacobian.partialPivLu().solve(residual);
    const double before = size(residual);
    double part = 1;
    for (int halving = 0; halving < max_halvings; ++halving, part /= 2) {
      residual = imbalance(y - part * step);
      if (size(residual) < before) break;
    }
    y -= part * step;
  }
  // Momenta from the forces themselves: handed over to rounding, not to the tolerance.
  if (body_.free) {
    state.body.v = start.v + h_ / (2 * body_.mass) * (f0.head<3>() + f.head<3>());
    state.body.L = start.L + h_ / 2 * (f0.segment<3>(3) + f.segment<3>(3));
  }
  state.impulse = impulse + h_ / 2 * (force_before + state.load.force);
  state.dissipated = dissipated + h_ / 2 * (dissipation_before + state.load.dissipation);
  return true;
}

}  // namespace mb
