#include "mechanics/geometry/superquadric.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/geometry/superquadric_valid.h"
#include "mechanics/geometry/tangents.h"

namespace mb {

namespace {

constexpr double least_ratio = 1e-9;  // in negative powers: of these ratios curvature would be infinite at 0

// norm = (a^p + b^p)^(1/p), first = a / norm, second = b / norm, and their duals, the derivatives of the norm,
// dual_first = first^(p-1). Scaled by the larger term: nothing overflows.
struct Pair {
  double norm, first, second, dual_first, dual_second;
};
Pair p_norm(double a, double b, double p) {
  if (a < b) {
    const Pair swapped = p_norm(b, a, p);
    return {swapped.norm, swapped.second, swapped.first, swapped.dual_second, swapped.dual_first};
  }
  const double ratio = a > 0 ? b / a : 1;  // at the centre as on the diagonal
  const double power = std::pow(ratio, p), scale = std::pow(1 + power, 1 / p);
  const double dual = scale / (1 + power);
  // ratio^(p-1), not where the quotient would have underflown.
  const double slope = ratio == 0 ? 0 : power > 1e-280 ? power / ratio : std::pow(ratio, p - 1);
  return {a * scale, 1 / scale, ratio / scale, dual, slope * dual};
}

// ratio^(p-2), kept finite.
double curving(double ratio, double p) { return std::pow(p < 2 ? std::max(ratio, least_ratio) : ratio, p - 2); }

struct Levels {
  Pair across, along;  // of (x/a1, y/a2), of (their norm, z/a3)
  double p, q;
};
Levels levels(const Superquadric& body, const Vector3d& x) {
  const Vector3d u = x.cwiseAbs().cwiseQuotient(body.semi_axes);
  const double p = 2 / body.e2, q = 2 / body.e1;
  const Pair across = p_norm(u[0], u[1], p);
  return {across, p_norm(across.norm, u[2], q), p, q};
}

double sign(double x) { return static_cast<double>((x > 0) - (x < 0)); }

// Of N, by the chain rule through r = |(x/a1, y/a2)|_p; with the ratios C S of the inner, R W of the outer norm and
// primes for duals (Barr 1981 has the gradient):
//   N_x  = R' C' / a1,   N_xx = R^(q-2) ((q-1) W^q C'^2 + (p-1) C^(p-2) S^p) / (N a1^2),   ...
GaugeDerivatives derivatives_in_octant(const Superquadric& body, const Levels& level) {
  const auto& [across, along, p, q] = level;
  const double C = across.dual_first, S = across.dual_second, R = along.dual_first, W = along.dual_second;
  const Vector3d gradient = Vector3d(R * C, R * S, W).cwiseQuotient(body.semi_axes);
  const double bend = curving(along.first, q) / along.norm;
  const double outer = (q - 1) * along.second * W, inner = (p - 1);
  Eigen::Matrix3d H;
  H(0, 0) = bend * (outer * C * C + inner * curving(across.first, p) * across.second * S);
  H(1, 1) = bend * (outer * S * S + inner * curving(across.second, p) * across.first * C);
  H(0, 1) = H(1, 0) = bend * (outer - inner) * C * S;
  H(0, 2) = H(2, 0) = -(q - 1) * R * W * C / along.norm;
  H(1, 2) = H(2, 1) = -(q - 1) * R * W * S / along.norm;
  H(2, 2) = (q - 1) * curving(along.second, q) * along.first * R / along.norm;
  const Vector3d scale = body.semi_axes.cwiseInverse();
  return {along.norm, gradient, H.cwiseProduct(scale * scale.transpose())};
}

// At c x, where x has the largest coordinate 1.
GaugeDerivatives derivatives_at_unit(const Superquadric& body, const Vector3d& x) {
  const GaugeDerivatives d = derivatives_in_octant(body, levels(body, x));
  const Vector3d signs = x.unaryExpr(&sign);
  return {d.value, signs.cwiseProduct(d.gradient),
          d.hessian.cwiseProduct(signs * signs.transpose() +
                                 Eigen::Matrix3d((1 - signs.array().square()).matrix().asDiagonal()))};
}

double largest(const Vector3d& x) { return x.cwiseAbs().maxCoeff(); }

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double gauge(const Superquadric& body, const Vector3d& x) {
  require_valid(body);
  if (!x.allFinite()) return nan;
  const double size = largest(x);
  return size > 0 ? size * levels(body, x / size).along.norm : 0;
}

double inside_outside(const Superquadric& body, const Vector3d& x) {
  const double N = gauge(body, x);
  return N * N;
}

GaugeDerivatives gauge_derivatives(const Superquadric& body, const Vector3d& x) {
  require_valid(body);
  if (!x.allFinite()) return {nan, Vector3d::Constant(nan), Eigen::Matrix3d::Constant(nan)};
  const double size = largest(x);
  if (size == 0) return {0, Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  GaugeDerivatives d = derivatives_at_unit(body, x / size);
  d.value *= size;
  d.hessian /= size;
  return d;
}

Vector3d outward_normal(const Superquadric& body, const Vector3d& x) {
  require_valid(body);
  if (!x.allFinite()) return Vector3d::Constant(nan);
  const double size = largest(x);
  if (size == 0) return Vector3d::UnitZ();
  return derivatives_at_unit(body, x / size).gradient.normalized();
}

PrincipalCurvatures principal_curvatures(const Superquadric& body, const Vector3d& x) {
  require_valid(body);
  if (!x.allFinite()) return {Eigen::Vector2d::Constant(nan), Eigen::Matrix<double, 3, 2>::Constant(nan)};
  const double size = largest(x);
  if (size == 0) return {Eigen::Vector2d::Zero(), tangents(Vector3d::UnitZ())};
  const GaugeDerivatives d = derivatives_at_unit(body, x / size);
  const double slope = d.gradient.norm();
  const Eigen::Matrix<double, 3, 2> T = tangents(d.gradient / slope);
  const Eigen::Matrix2d bending = T.transpose() * d.hessian * T / slope;
  const double mean = 0.5 * (bending(0, 0) + bending(1, 1)), half = 0.5 * (bending(0, 0) - bending(1, 1));
  const double radius = std::hypot(half, bending(0, 1)), angle = 0.5 * std::atan2(bending(0, 1), half);
  const Eigen::Vector2d steepest(std::cos(angle), std::sin(angle)), other(-steepest[1], steepest[0]);
  PrincipalCurvatures principal{Eigen::Vector2d(std::max(0.0, mean - radius), mean + radius) / size, T};
  principal.directions << T * other, T * steepest;
  return principal;
}

}  // namespace mb
