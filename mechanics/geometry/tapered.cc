#include "mechanics/geometry/tapered.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/dual_norm.h"
#include "mechanics/geometry/root.h"
#include "mechanics/geometry/superquadric_chart.h"
#include "mechanics/geometry/superquadric_valid.h"
#include "mechanics/geometry/tangents.h"

namespace mb {

namespace {

constexpr double least_factor = 1e-9;  // [-] of c: points far outside the body
constexpr int most_power = 20;

double binomial(int n, int m) {
  double c = 1;
  for (int i = 0; i < m; ++i) c = c * (n - i) / (i + 1);
  return c;
}

double mean_square(const Superquadric& body) {  // [-] of Z/a3
  const Superquadric unit{Vector3d::Ones(), body.e1, body.e2};
  return moment(unit, 0, 0, 2) / moment(unit, 0, 0, 0);
}

double side(double w) { return w < 0 ? -1 : 1; }

// tau at which the profile has the slope sigma [-], df/dw < k in that half; it falls with w.
double tau_of_slope(const TaperedSuperquadric& body, int half, double sigma) {
  const auto excess = [&](double tau) {
    const TaperedProfile p = tapered_profile(body, half, tau);
    return p.slope - sigma * p.weight;
  };
  return root_between(excess, -most_tau, most_tau, 1e-15);
}

// The profile's point of slope sigma, of both halves: its radius and height [-].
Eigen::Vector2d of_slope(const TaperedSuperquadric& body, double sigma) {
  const int half = sigma < body.taper ? 1 : -1;
  const TaperedProfile p = tapered_profile(body, half, tau_of_slope(body, half, half * sigma));
  return {p.radius, half * p.w};
}

}  // namespace

double largest_taper(double e1) { return std::exp2(e1 / 2) * (1 - e1 / 2); }

void require_valid(const TaperedSuperquadric& body) {
  require_valid(body.straight);
  const double most = largest_taper(body.straight.e1);
  if (!(std::abs(body.taper) <= most))
    throw std::invalid_argument(fmt::format("tapered superquadric: the taper is {}, at most {} for e1 = {}", body.taper,
                                            most, body.straight.e1));
}

Taper::Taper(const TaperedSuperquadric& body) : rate_(body.taper / body.straight.semi_axes[2]), shift_(0) {
  require_valid(body);
  if (body.taper == 0) return;
  const double k = body.taper, m = mean_square(body.straight);
  shift_ = body.straight.semi_axes[2] * 2 * k * m / (1 + k * k * m);
}

Vector3d Taper::apply(const Vector3d& X) const {
  const double c = factor(X[2]);
  return {c * X[0], c * X[1], X[2] - shift_};
}
Vector3d Taper::inverse(const Vector3d& x) const {
  const double Z = x[2] + shift_, c = std::max(factor(Z), least_factor);
  return {x[0] / c, x[1] / c, Z};
}
Eigen::Matrix3d Taper::gradient(const Vector3d& X) const {
  const double c = factor(X[2]);
  Eigen::Matrix3d F;
  F << c, 0, rate_ * X[0], 0, c, rate_ * X[1], 0, 0, 1;
  return F;
}
Vector3d Taper::area(const Vector3d& X, const Vector3d& n) const {
  const double c = factor(X[2]);
  return {c * n[0], c * n[1], c * c * n[2] - c * rate_ * (X[0] * n[0] + X[1] * n[1])};
}

TaperedProfile tapered_profile(const TaperedSuperquadric& body, int half, double tau) {
  const Ratios of = ratios(tau, 2 / body.straight.e1 - 1);
  const double k = half * body.taper, c = 1 + k * of.second;
  return {of.second, of.first, c * of.first, k * of.share_first - c * of.dual_second, of.dual_first};
}

double section_support(const TaperedSuperquadric& body, const Eigen::Vector2d& n) {
  const Eigen::Vector2d scaled = body.straight.semi_axes.head<2>().cwiseProduct(n.cwiseAbs());
  return scaled.maxCoeff() > 0 ? scaled.dot(dual_gradient(scaled[0], scaled[1], body.straight.e2)) : 0;
}

Eigen::AlignedBox3d bounds(const TaperedSuperquadric& body) {
  const Taper taper(body);
  const double widest = of_slope(body, 0)[0];
  const Vector3d& a = body.straight.semi_axes;
  return {Vector3d(-widest * a[0], -widest * a[1], -a[2] - taper.shift()),
          Vector3d(widest * a[0], widest * a[1], a[2] - taper.shift())};
}

Vector3d farthest(const TaperedSuperquadric& body, const Vector3d& w) {
  const Taper taper(body);
  const Superquadric& straight = body.straight;
  const Vector3d& a = straight.semi_axes;
  const Vector3d scaled = a.cwiseProduct(w.cwiseAbs());
  const double largest = scaled.maxCoeff();
  if (!(largest > 0)) return {0, 0, a[2] - taper.shift()};
  const Eigen::Vector2d u = scaled.head<2>() / largest;
  const Eigen::Vector2d across =
      u.maxCoeff() > 0 ? dual_gradient(u[0], u[1], straight.e2) : Eigen::Vector2d(Eigen::Vector2d::UnitX());
  const double out = across.dot(u), up = side(w[2]) * scaled[2] / largest;
  const Eigen::Vector2d at = out > 1e-30 ? of_slope(body, -up / out) : Eigen::Vector2d(0, side(w[2]));
  return {side(w[0]) * at[0] * a[0] * across[0], side(w[1]) * at[0] * a[1] * across[1], at[1] * a[2] - taper.shift()};
}

// x^i y^j z^k = c^(i+j) X^i Y^j (Z - z0)^k, and volume elements grow by c^2: sums of moments of the straight body.
double moment(const TaperedSuperquadric& body, int i, int j, int k) {
  for (const int power : {i, j, k})
    if (power < 0 || power > most_power)
      throw std::invalid_argument(fmt::format("moment: power {} is not in [0, {}]", power, most_power));
  const Taper taper(body);
  if (body.taper == 0) return moment(body.straight, i, j, k);
  double sum = 0;
  for (int b = 0; b <= k; ++b)
    for (int m = 0; m <= i + j + 2; ++m) {
      if ((b + m) % 2 == 1 || b + m > 40) continue;
      sum += binomial(k, b) * std::pow(-taper.shift(), k - b) * binomial(i + j + 2, m) * std::pow(taper.rate(), m) *
             moment(body.straight, i, j, b + m);
    }
  return sum;
}

// Of N(X(x)), the straight body's gauge: gradient B^T g and Hessian B^T H B + g_1 X_xx + g_2 Y_xx with B = F^-1.
TaperedBend tapered_bend(const TaperedSuperquadric& body, const Vector3d& x) {
  const Taper taper(body);
  const Vector3d X = taper.inverse(x);
  const double c = std::max(taper.factor(X[2]), least_factor), rate = taper.rate();
  const GaugeDerivatives N = gauge_derivatives(body.straight, X);
  Eigen::Matrix3d B;
  B << 1 / c, 0, -rate * X[0] / c, 0, 1 / c, -rate * X[1] / c, 0, 0, 1;
  Eigen::Matrix3d H = B.transpose() * N.hessian * B;
  for (int i = 0; i < 2; ++i) {
    H(i, 2) -= N.gradient[i] * rate / (c * c);
    H(2, i) = H(i, 2);
    H(2, 2) += N.gradient[i] * 2 * rate * rate * X[i] / (c * c);
  }
  const Vector3d gradient = B.transpose() * N.gradient;
  const double slope = gradient.norm();
  if (!(slope > 0)) return {0, Vector3d::UnitZ(), {Eigen::Vector2d::Zero(), tangents(Vector3d::UnitZ())}};
  const Eigen::Matrix<double, 3, 2> T = tangents(gradient / slope);
  const Eigen::Matrix2d bending = T.transpose() * H * T / slope;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spectrum;
  spectrum.computeDirect(0.5 * (bending + bending.transpose()));
  return {slope, gradient / slope, {spectrum.eigenvalues().cwiseMax(0), T * spectrum.eigenvectors()}};
}

}  // namespace mb
