#include "modal/frame/body_flight.h"

#include <cmath>

#include "mechanics/rigid/inertia.h"
#include "modal/frame/spin.h"

namespace mb {

BodyFlight::BodyFlight(const FloatingBody& body, const BodyState& start, double t0)
    : body_(body), start_(start), t0_(t0), axes_(1, 0, 0, 0) {
  start_.s.conservativeResize(body.n_static());
  if (body.static_damping == 0) start_.s.setZero();  // no force, no static shape
  if (body.free && (body.coupling || body.loads)) coupled_.emplace(body, start_, t0);
  if (!body.free || coupled_ || start.L.isZero(0)) return;
  const PrincipalAxes principal = principal_axes(body.inertia);
  axes_ = principal.axes;
  const Vector3d Omega = start.Q.conjugate() * angular_velocity(body, start);
  rotation_.emplace(principal.moments, start.Q * axes_, axes_.conjugate() * Omega);
}

BodyState BodyFlight::at(double t) const {
  BodyState now = coupled_ ? coupled_->at(t) : start_;
  const double tau = t - t0_;
  if (body_.free && !body_.loads) {
    now.c += tau * start_.v + (tau * tau / 2) * body_.gravity;
    now.v += tau * body_.gravity;
    if (rotation_) now.Q = rotation_->at(tau).orientation * axes_.conjugate();
  }
  if (body_.static_damping > 0) now.s *= std::exp(-tau / body_.static_damping);
  if (coupled_) return now;
  for (Index i = 0; i < body_.n_modes(); ++i) {
    const Response x = response(body_.modes[static_cast<size_t>(i)], tau);
    now.q[i] = x.C * start_.q[i] + x.S * start_.p[i] + x.P * body_.weight[i];
    now.p[i] = x.C_dot * start_.q[i] + x.S_dot * start_.p[i] + x.S * body_.weight[i];
  }
  return now;
}

}  // namespace mb
