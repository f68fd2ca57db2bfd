// Moments in closed form, area by quadrature. With the surface point x = y / N(y) for y on the box |y_i| <= a_i, and
// s, t in [0, 1] across a quarter of one of its faces, y_i = a_i (1, s, t),
//
//   dA = a1 a2 a3 |grad N| / N^3 ds dt,   both at y
#include <cmath>
#include <stdexcept>
#include <string>

#include "mechanics/geometry/superquadric.h"
#include "mechanics/geometry/superquadric_valid.h"
#include "mechanics/geometry/tapered.h"

namespace mb {

namespace {

double raised(double base, int power) {
  double result = 1;
  for (int i = 0; i < power; ++i) result *= base;
  return result;
}

double beta(double a, double b) { return std::tgamma(a) * std::tgamma(b) / std::tgamma(a + b); }

struct Node {
  double x, w;  // [-]
};

// Double exponential rule on [0, 1] (Takahasi & Mori 1974): x = 1 / (1 + exp(-pi sinh k h)). Derivatives of N are
// infinite at s = 0 where e > 1; such ends do not slow it down.
std::vector<Node> double_exponential(double h) {
  const int n = static_cast<int>(std::ceil(3.3 / h));  // beyond, weights are below 1e-17
  std::vector<Node> nodes;
  for (int k = -n; k <= n; ++k) {
    const double x = 1 / (1 + std::exp(-pi * std::sinh(k * h))), other = 1 / (1 + std::exp(pi * std::sinh(k * h)));
    nodes.push_back({x, h * pi * std::cosh(k * h) * x * other});
  }
  return nodes;
}

}  // namespace

void require_valid(const Superquadric& body) {
  const auto require = [](double value, double least, double most, const char* what) {
    if (!(value >= least && value <= most))
      throw std::invalid_argument("superquadric: " + std::string(what) + " is " + std::to_string(value));
  };
  for (const double a : body.semi_axes) require(a, 1e-100, 1e100, "a semi-axis not in [1e-100, 1e100] m");
  for (const double e : {body.e1, body.e2}) require(e, 0.1, 2, "an exponent not in [0.1, 2]");
}

double moment(const Superquadric& body, int i, int j, int k) {
  require_valid(body);
  for (const int power : {i, j, k})
    if (power < 0 || power > 40)
      throw std::invalid_argument("moment: power " + std::to_string(power) + " is not in [0, 40]");
  if (i % 2 + j % 2 + k % 2 > 0) return 0;
  const double p = 2 / body.e2, q = 2 / body.e1;
  const double m = i + 1, n = j + 1, l = k + 1;
  const double along = std::tgamma((m + n) / q) * std::tgamma(l / q) / std::tgamma((m + n + l) / q + 1);
  const Vector3d& a = body.semi_axes;
  return 8 * raised(a[0], i + 1) * raised(a[1], j + 1) * raised(a[2], k + 1) * beta(m / p, n / p) * along / (p * q * q);
}

SurfaceMoments surface_moments(const Superquadric& body) { return surface_moments(TaperedSuperquadric{body, 0}); }

SurfaceMoments surface_moments(const TaperedSuperquadric& tapered) {
  const Taper taper(tapered);
  const Superquadric& body = tapered.straight;
  const auto nodes = double_exponential(1.0 / 12);
  const Vector3d& a = body.semi_axes;
  const Vector3d faces(a[1] * a[2], a[2] * a[0], a[0] * a[1]);  // a1 a2 a3 grad N = faces * (a grad N): no overflow
  const std::vector<double> halves = tapered.taper == 0 ? std::vector{1.0} : std::vector{1.0, -1.0};
  const double alike = 8 / static_cast<double>(halves.size());
  double area = 0, first = 0;
  Vector3d second = Vector3d::Zero();  // by a_i^2
  for (const auto& s : nodes)
    for (const auto& t : nodes)
      for (int axis = 0; axis < 3; ++axis)
        for (const double half : halves) {
          Vector3d u = Vector3d::Ones();
          u[(axis + 1) % 3] = s.x;
          u[(axis + 2) % 3] = t.x;
          u[2] *= half;
          const GaugeDerivatives d = gauge_derivatives(body, a.cwiseProduct(u));
          const Vector3d X = a.cwiseProduct(u / d.value), x = taper.apply(X);
          const double element = taper.area(X, faces.cwiseProduct(a.cwiseProduct(d.gradient))).norm();
          const double weight = alike * s.w * t.w * element / (d.value * d.value * d.value);
          area += weight;
          first += halves.size() > 1 ? weight * x[2] : 0;
          second += weight * x.cwiseQuotient(a).cwiseAbs2();
        }
  return {area, second.cwiseProduct(a.cwiseAbs2()), first};
}

}  // namespace mb
