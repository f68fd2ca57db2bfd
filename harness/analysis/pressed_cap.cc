#include "harness/analysis/pressed_cap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/contact/first_touch_support.h"
#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/superquadric.h"

namespace mb {

namespace {

constexpr int n_phi = 24, n_s = 8;  // to begin with
constexpr int most_doublings = 3;
constexpr double accurate = 1e-6;  // [-] of doubled numbers of points

// The surface point on the ray from p, inside, along e: N is convex along it, so that Newton's method from outside
// comes down on it.
Vector3d on_ray(const Superquadric& body, const Vector3d& p, const Vector3d& e) {
  double r = 2 * body.semi_axes.norm();
  for (int i = 0; i < 100; ++i) {
    const GaugeDerivatives N = gauge_derivatives(body, p + r * e);
    const double step = (N.value - 1) / N.gradient.dot(e);
    if (!(step > 1e-15 * r)) break;
    r -= step;
  }
  return p + r * e;
}

struct Frame {
  Vector3d deepest, up, e1, e2;
};

Frame frame(const Shape& shape, const Vector3d& down) {
  const Vector3d up = -down.normalized(), e1 = up.unitOrthogonal();
  return {support_point(shape, -up), up, e1, up.cross(e1)};
}

PlaneContact integral(const Superquadric& body, const Frame& at, double depth, int n_directions, int n_heights) {
  const Rule rule = gauss_legendre(n_heights);
  PlaneContact sum{0, 0, 0, depth, 0};
  for (int j = 0; j < n_heights; ++j) {
    const double s = rule.x[j], h = depth * s * s, g = depth * (1 - s * s);
    double around = 0;
    for (int i = 0; i < n_directions; ++i) {
      const double phi = 2 * pi * i / n_directions;
      const Vector3d e = std::cos(phi) * at.e1 + std::sin(phi) * at.e2, axis = at.deepest + h * at.up;
      const Vector3d x = on_ray(body, axis, e);
      around += (x - axis).dot(e) / outward_normal(body, x).dot(e);
    }
    const double dA = 2 * pi / n_directions * around * rule.w[j] * 2 * depth * s;
    sum.area += dA;
    sum.force += dA * g;
    sum.energy += dA * g * g / 2;
  }
  return sum;
}

double reach(const Superquadric& body, const Frame& at, double depth) {
  double farthest = 0;
  for (int i = 0; i < 2 * n_phi; ++i) {
    const double phi = pi * i / n_phi;
    const Vector3d e = std::cos(phi) * at.e1 + std::sin(phi) * at.e2;
    farthest = std::max(farthest, (on_ray(body, at.deepest + depth * at.up, e) - at.deepest).norm());
  }
  return farthest;
}

double difference(const PlaneContact& a, const PlaneContact& b) {
  return std::max({std::abs(a.area / b.area - 1), std::abs(a.force / b.force - 1), std::abs(a.energy / b.energy - 1)});
}

PressedCap cap_of(const Sphere& sphere, double depth) {
  const double R = sphere.radius;
  return {contact_by_curvatures(1 / R, 1 / R, depth), 0, std::sqrt(2 * R * depth)};
}

}  // namespace

PressedCap pressed_cap(const Shape& shape, const Vector3d& down, double depth) {
  if (!down.allFinite() || !(down.norm() > 0)) throw std::invalid_argument("pressed cap: no direction of the plane");
  if (!(depth > 0) || !std::isfinite(depth)) throw std::invalid_argument("pressed cap: the depth is not positive");
  const Frame at = frame(shape, down);
  if (depth > -at.deepest.dot(at.up)) throw std::invalid_argument("pressed cap: deeper than to the body's centre");
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return cap_of(*sphere, depth);
  const auto* body = std::get_if<Superquadric>(&shape);
  if (!body) throw std::invalid_argument("pressed cap: only of spheres and superquadrics");
  PressedCap cap{integral(*body, at, depth, n_phi, n_s), 1, reach(*body, at, depth)};
  for (int i = 1; i <= most_doublings && cap.error > accurate; ++i) {
    const PlaneContact finer = integral(*body, at, depth, n_phi << i, n_s << i);
    cap.error = difference(cap.contact, finer);
    cap.contact = finer;
  }
  return cap;
}

}  // namespace mb
