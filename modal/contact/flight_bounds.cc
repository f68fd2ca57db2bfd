#include "modal/contact/flight_bounds.h"

#include <algorithm>
#include <cmath>

namespace mb {

namespace {

FlightBounds uncoupled(const FloatingBody& body, const ShapeBounds& shapes, const BodyState& state, double duration) {
  const AmplitudeBounds a = amplitude_bounds(body, state.q, state.p, duration);
  FlightBounds bounds{0,
                      0,
                      a.q.dot(shapes.value),
                      a.p.dot(shapes.value),
                      a.a.dot(shapes.value),
                      a.q.dot(shapes.bend),
                      a.p.dot(shapes.bend)};
  if (!body.free) return bounds;
  const Vector3d J = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia, Eigen::EigenvaluesOnly).eigenvalues();
  bounds.Omega = state.L.norm() / J[0];
  bounds.Omega_t = J[2] / J[0] * bounds.Omega * bounds.Omega;
  return bounds;
}

struct Spectrum {
  VectorXd lambda, c;
};
Spectrum spectrum(const FloatingBody& body) {
  Spectrum of{VectorXd(body.n_modes()), VectorXd(body.n_modes())};
  for (Index i = 0; i < body.n_modes(); ++i) {
    of.lambda[i] = body.modes[static_cast<size_t>(i)].k;
    of.c[i] = 2 * body.modes[static_cast<size_t>(i)].h;
  }
  return of;
}

double twice_energy(const FloatingBody& body, const Spectrum& modes, const BodyState& state) {
  const Spin now = spin(body, state);
  const double all = (state.Q * now.Omega).dot(state.L) + now.rate.dot(state.p) + modes.lambda.dot(state.q.cwiseAbs2());
  return std::max(0.0, all);
}

std::optional<FlightBounds> coupled(const FloatingBody& body, const ShapeBounds& shapes, const BodyState& state) {
  const Spectrum modes = spectrum(body);
  const double e = std::sqrt(twice_energy(body, modes, state));
  const Vector3d J = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia, Eigen::EigenvaluesOnly).eigenvalues();
  const bool any = modes.lambda.size() > 0;
  if (any && !(modes.lambda.minCoeff() > 0)) return std::nullopt;
  const double q = any ? e / std::sqrt(modes.lambda.minCoeff()) : 0, U = std::sqrt(J[2]),
               J_least = J[0] - 2 * U * q - body.coupling->s * e * e, arm = U + q + body.coupling->g * e;
  if (!(J_least > 0)) return std::nullopt;
  FlightBounds b{};
  b.Omega = e / std::sqrt(J_least);
  const double q_t = any ? e + b.Omega * q : 0;
  const double spinning = b.Omega * b.Omega * arm + 2 * b.Omega * q_t;
  const double elastic = any ? std::sqrt(modes.lambda.maxCoeff()) * e + modes.c.maxCoeff() * q_t : 0;
  b.Omega_t = (2 * b.Omega * q_t * arm + b.Omega * state.L.norm() + q * (spinning + elastic)) / J_least;
  const auto over = [&](const VectorXd& a, const VectorXd& scale) { return a.cwiseProduct(scale).norm(); };
  const VectorXd root = modes.lambda.cwiseSqrt(), compliance = root.cwiseInverse();
  b.u = e * over(shapes.value, compliance);
  b.bend = e * over(shapes.bend, compliance);
  b.u_t = q_t * shapes.value.norm();
  b.bend_rate = q_t * shapes.bend.norm();
  b.u_tt = e * over(shapes.value, root) + q_t * over(shapes.value, modes.c) +
           (spinning + b.Omega_t * q) * shapes.value.norm();
  return b;
}

}  // namespace

std::optional<FlightBounds> flight_bounds(const FloatingBody& body, const ShapeBounds& shapes, const BodyState& state,
                                          double duration) {
  return body.coupling && body.free ? coupled(body, shapes, state) : uncoupled(body, shapes, state, duration);
}

}  // namespace mb
