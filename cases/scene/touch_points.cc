#include "cases/scene/touch_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/superquadric.h"

namespace mb {

namespace {

using GapOf = std::function<double(const Vector3d& X)>;  // [m]
constexpr double flat = 1e-9;                            // [-] of the extent: heights that close are one
constexpr int n_looks = 512;                             // at the way, before touch is pinned down

// The surface's point on the ray through u from the centre, with which every shape is star-shaped.
Vector3d surface_point(const Shape& shape, const Vector3d& u) {
  const double across = u.head<2>().norm(), along = 2 * std::abs(u[2]);
  return u / std::visit(overloaded{[&](const Box& b) { return 2 * u.cwiseQuotient(b.size).cwiseAbs().maxCoeff(); },
                                   [&](const Cylinder& c) { return std::max(across / c.radius, along / c.length); },
                                   [&](const Sphere& s) { return u.norm() / s.radius; },
                                   [&](const Superquadric& s) { return gauge(s, u); }},
                        shape);
}

// The middle of the points farthest along n [-, unit] within `flat`, in closed form, for shapes that have one.
std::optional<Vector3d> farthest(const Shape& shape, const Vector3d& n) {
  const auto end = [&](double size, double along) {
    return std::abs(along) * size <= flat * extent(shape) ? 0 : std::copysign(0.5 * size, along);
  };
  if (const auto* s = std::get_if<Sphere>(&shape)) return s->radius * n;
  if (const auto* b = std::get_if<Box>(&shape))
    return Vector3d(end(b->size[0], n[0]), end(b->size[1], n[1]), end(b->size[2], n[2]));
  const auto* c = std::get_if<Cylinder>(&shape);
  if (!c) return std::nullopt;
  const double across = n.head<2>().norm(), r = end(2 * c->radius, across);
  return r * Vector3d(n[0], n[1], 0) / std::max(across, flat) + end(c->length, n[2]) * Vector3d::UnitZ();
}

// Of samples of the surface; the middle of those within `flat` of the least gap, where it is one of them.
Vector3d lowest_sample(const Shape& shape, const Quadrature& samples, const GapOf& gap) {
  VectorXd gaps(samples.weights.size());
  for (Index i = 0; i < gaps.size(); ++i) gaps[i] = gap(samples.points.col(i));
  Index first = 0;
  const double least = gaps.minCoeff(&first), tolerance = flat * extent(shape);
  const VectorXd w = (gaps.array() <= least + tolerance).select(samples.weights, 0);
  const Vector3d middle = samples.points * w / w.sum();
  if (middle.norm() > tolerance && std::abs(gap(middle) - least) <= tolerance) return surface_point(shape, middle);
  return samples.points.col(first);
}

// Looks about X on grids of directions, which close in only where a point within them is best: they follow edges.
Vector3d lowest(const Shape& shape, Vector3d X, const GapOf& gap) {
  double best = gap(X), width = 0.3;
  for (int look = 0; look < 200 && width > 1e-6; ++look) {
    const Vector3d u = X.normalized(), e = u.unitOrthogonal(), f = u.cross(e);
    int ring = 0;
    for (int k = 0; k < 49; ++k) {
      const int i = k / 7 - 3, j = k % 7 - 3;
      const Vector3d at = surface_point(shape, u + width / 3 * (i * e + j * f));
      if (!(gap(at) < best - 1e-12 * extent(shape))) continue;
      best = gap(at), X = at, ring = std::max(std::abs(i), std::abs(j));
    }
    if (ring < 3) width *= 0.5;
  }
  return X;
}

// At the first touch on the way, if there is one, else at the nearest approach.
Vector3d nearest(const Shape& shape, double duration, const std::function<double(const Vector3d& X, double t)>& gap) {
  const auto at = [&](double t) { return [&gap, t](const Vector3d& X) { return gap(X, t); }; };
  const Quadrature samples = surface_quadrature(shape);
  Vector3d X = lowest_sample(shape, samples, at(0));
  double t = 0;
  for (int k = 1; k <= n_looks && gap(X, t) > 0; ++k) {
    const Vector3d sample = lowest_sample(shape, samples, at(duration * k / n_looks));
    if (gap(sample, duration * k / n_looks) < gap(X, t)) X = sample, t = duration * k / n_looks;
  }
  X = lowest(shape, X, at(t));
  for (int pass = 0; pass < 6 && t > 0 && gap(X, t) < 0; ++pass) {  // X touches earlier, then another X deeper there
    for (double before = 0, step = 0; step < 50; ++step)
      (gap(X, 0.5 * (before + t)) > 0 ? before : t) = 0.5 * (before + t);
    X = lowest(shape, X, at(t));
  }
  return X;
}

Vector3d touch_point(const Scene& scene, const Body& body, const RigidSurface& surface) {
  const auto& [position, orientation] = body.pose;
  const double moves = body.supports.empty() ? 1 : 0, T = scene.duration;
  const Vector3d v = moves * body.twist.velocity, g = moves * scene.gravity;
  if (!(position + v + T * T * g).allFinite() || !(T >= 0) || !(std::abs(orientation.norm() - 1) < 1e-9))
    throw std::invalid_argument("body '" + body.name + "': its pose, its velocity or the duration is no number");
  if (std::holds_alternative<HalfSpace>(surface.shape)) {
    const Vector3d down = -(orientation.conjugate() * (surface.pose.orientation * Vector3d::UnitZ()));
    if (const auto X = farthest(body.shape, down)) return *X;
  }
  return nearest(body.shape, T, [&](const Vector3d& X, double t) {
    return gap_value(surface, position + t * v + 0.5 * t * t * g + orientation * X);
  });
}

}  // namespace

std::vector<Vector3d> touch_points(const Scene& scene, const Body& body) {
  std::vector<Vector3d> points;
  for (const ContactPair& pair : scene.contacts) {
    if (pair.body != body.name) continue;
    const auto obstacle = std::ranges::find(scene.obstacles, pair.obstacle, &Obstacle::name);
    if (obstacle == scene.obstacles.end())
      throw std::invalid_argument("body '" + body.name + "' touches an unknown obstacle '" + pair.obstacle + "'");
    points.push_back(touch_point(scene, body, obstacle->surface));
  }
  return points;
}

}  // namespace mb
