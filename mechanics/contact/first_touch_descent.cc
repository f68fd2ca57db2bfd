#include "mechanics/contact/first_touch_descent.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/contact/first_touch_support.h"

namespace mb {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double h = 1e-5;      // of differences: Newton then gains five digits a step
constexpr int max_steps = 100;  // halvings near sharp edges of the obstacle; smooth pairs take three to six
constexpr int max_trials = 60;
constexpr double converged = 1e-8;
constexpr int max_crossings = 16;
constexpr int max_supports = 20;

// Of a slope in the parameters whether it falls over this edge outwards.
bool falls_out(const Eigen::Vector2d& slope, int edge) { return edge % 2 ? slope[edge / 2] < 0 : slope[edge / 2] > 0; }
bool on_edge(const PatchPoint& p, int edge) { return (edge < 2 ? p.s : p.t) == edge % 2; }

// Newton's step with |curvatures| and at most 1 long.
Eigen::Vector2d newton(const Eigen::Vector2d& slope, const Eigen::Matrix2d& bend, double least_bend) {
  const double mean = 0.5 * (bend(0, 0) + bend(1, 1)), half = 0.5 * (bend(0, 0) - bend(1, 1));
  const double radius = std::hypot(half, bend(0, 1));
  const double angle = radius > 0 ? 0.5 * std::atan2(bend(0, 1), half) : 0;
  const Eigen::Vector2d e1(std::cos(angle), std::sin(angle)), e2(-e1[1], e1[0]);
  const Eigen::Vector2d step = -e1.dot(slope) / std::max(std::abs(mean + radius), least_bend) * e1 -
                               e2.dot(slope) / std::max(std::abs(mean - radius), least_bend) * e2;
  const double largest = step.cwiseAbs().maxCoeff();
  return largest > 1 ? Eigen::Vector2d(step / largest) : step;
}

// The same where parameters at 0 or 1 may rest there, cut off where it leaves the patch.
Eigen::Vector2d projected_newton(const PatchPoint& p, const Eigen::Vector2d& slope, const Eigen::Matrix2d& bend,
                                 double least_bend) {
  bool free[2] = {true, true};
  const auto stop = [&](const Eigen::Vector2d& out, double sign) {
    for (int edge = 0; edge < 4; ++edge)
      if (free[edge / 2] && on_edge(p, edge) && falls_out(sign * out, edge)) return free[edge / 2] = false, true;
    return false;
  };
  while (stop(slope, 1)) continue;
  Eigen::Vector2d step;
  do {
    step.setZero();
    if (free[0] && free[1]) step = newton(slope, bend, least_bend);
    for (int a = 0; a < 2; ++a)
      if (free[a] && !free[1 - a]) {
        step[a] = -slope[a] / std::max(std::abs(bend(a, a)), least_bend);
        step[a] = std::min(1.0, std::max(-1.0, step[a]));
      }
  } while (stop(step, -1));
  // The parameter that leaves the patch first stops at its border, the other goes its own way.
  const Eigen::Vector2d z(p.s, p.t);
  const auto room = [&](int a) { return (step[a] > 0 ? 1 - z[a] : -z[a]); };
  const auto share = [&](int a) { return step[a] == 0 ? infinity : room(a) / step[a]; };
  const int first = share(0) < share(1) ? 0 : 1, other = 1 - first;
  if (share(first) < 1) {
    step[first] = room(first);
    if (step[other] != 0)
      step[other] = -(slope[other] + bend(0, 1) * step[first]) / std::max(std::abs(bend(other, other)), least_bend);
  }
  if (share(other) < 1) step[other] = room(other);
  return step;
}

// Onto the border where a step was to end there.
double clamped(double z) { return z < 4 * eps ? 0 : z > 1 - 4 * eps ? 1 : z; }

// gap() counts curvatures above 1e9 / extent as that (signed_distance.h). Nearer to a sharp edge than 1e-9 of the
// extent they are 1 / gap, and Newton's steps would be too long.
Gap sharp_gap(const RigidSurface& obstacle, const Vector3d& x) {
  Gap g = gap(obstacle, x);
  const auto* shape = std::get_if<Shape>(&obstacle.shape);
  if (!shape || obstacle.rounding > 0 || !(g.value > 0) || g.value > 1e-9 * extent(*shape)) return g;
  const double clipped = 1e9 / extent(*shape);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(g.hessian);
  for (int i = 0; i < 3; ++i) {
    const Vector3d e = eigen.eigenvectors().col(i);
    if (eigen.eigenvalues()[i] > 0.9 * clipped) g.hessian += (1 / g.value - clipped) * e * e.transpose();
  }
  return g;
}

}  // namespace

void CountedMotion::at(double t, std::span<const Vector3d> X, std::span<PointMotion> out) {
  motion_.at(t, X, out);
  n_ += static_cast<long>(X.size());
  for (const PointMotion& m : out)
    if (!(m.x.allFinite() && m.v.allFinite() && m.F.allFinite() && m.F_rate.allFinite()))
      throw std::invalid_argument(fmt::format("first_touch: the motion is not finite at t = {} s", t));
}

MotionBounds CountedMotion::bounds(double ta, double tb) const {
  const MotionBounds b = motion_.bounds(ta, tb);
  for (const double bound : {b.spread, b.bend, b.bend_rate})
    if (!(std::isfinite(bound) && bound >= 0))
      throw std::invalid_argument(
          fmt::format("first_touch: a bound of the motion over [{}, {}] s is {}, not finite and >= 0", ta, tb, bound));
  if (!b.acceleration.allFinite())
    throw std::invalid_argument(fmt::format("first_touch: the acceleration over [{}, {}] s is not finite", ta, tb));
  return b;
}

NearPoint Descent::at(const PatchPoint& point, double t) const {
  NearPoint p{point, surface_.patch(point.patch).at(point.s, point.t).x, {}, {}, {}};
  motion_.at(t, {&p.X, 1}, {&p.motion, 1});
  p.gap = sharp_gap(obstacle_, p.motion.x);
  p.normal = p.gap.normal;
  return p;
}

double Descent::plane_gap(const NearPoint& p) const {
  const auto point = support_point(obstacle_, p.normal);
  return point ? p.normal.dot(p.motion.x - *point) : p.gap.value;
}

Descent::Model Descent::model(const NearPoint& p, double t) const {
  const double hs = p.at.s < 0.5 ? h : -h, ht = p.at.t < 0.5 ? h : -h;
  const SurfacePatch& patch = surface_.patch(p.at.patch);
  const SurfacePoint here = patch.at(p.at.s, p.at.t);
  const SurfacePoint by[2] = {patch.at(p.at.s + hs, p.at.t), patch.at(p.at.s, p.at.t + ht)};
  const Vector3d X[2] = {by[0].x, by[1].x};
  PointMotion motions[2];
  motion_.at(t, X, motions);
  const Vector3d& n = p.gap.normal;
  const Vector3d w = p.motion.F.transpose() * n;
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << p.motion.F * here.by_s, p.motion.F * here.by_t;
  Model m{{w.dot(here.by_s), w.dot(here.by_t)},
          {},
          p.gap.hessian * tangents,
          {here.by_s.norm(), here.by_t.norm()},
          w.norm()};
  Eigen::Matrix2d change;
  for (int b = 0; b < 2; ++b) {
    const Vector3d w_b = motions[b].F.transpose() * n;
    change.col(b) = (Eigen::Vector2d(w_b.dot(by[b].by_s), w_b.dot(by[b].by_t)) - m.slope) / (b == 0 ? hs : ht);
  }
  m.bend = tangents.transpose() * m.turning + 0.5 * (change + change.transpose());
  if (!m.bend.allFinite()) m.bend.setZero();  // an edge of a superquadric: then downhill as on a plane
  return m;
}

// The patch beyond an edge at which f falls outwards, where it falls inwards there, too: not so at an edge of the body.
std::optional<NearPoint> Descent::beyond(const NearPoint& p, const Model& m) const {
  for (int edge = 0; edge < 4; ++edge) {
    if (!(on_edge(p.at, edge) && falls_out(m.slope, edge))) continue;
    const TouchSurface::Across across = surface_.across(p.at, edge);
    const SurfacePoint there = surface_.patch(across.point.patch).at(across.point.s, across.point.t);
    const Vector3d& inwards = across.edge < 2 ? there.by_s : there.by_t;
    const double slope = (p.motion.F.transpose() * p.gap.normal).dot(inwards) * (across.edge % 2 ? -1 : 1);
    if (slope < -1e-9 * m.steepness * inwards.norm())
      return NearPoint{across.point, there.x, p.motion, p.gap, p.normal};
  }
  return std::nullopt;
}

// A point along the step that lies lower by a part of what the slope promises (Armijo) and where f does not rise again
// (Wolfe): across edges of the obstacle f is a valley with a bottom as narrow as the gap. By secants and halves of the
// slope along the step; the lowest point seen where they come to no end.
std::optional<NearPoint> Descent::lower(const NearPoint& p, const Model& m, const Eigen::Vector2d& step,
                                        double t) const {
  const double slope0 = m.slope.dot(step);
  if (!(slope0 < 0)) return std::nullopt;
  double left = 0, right = 1, slope_left = slope0, slope_right = 0;
  std::optional<NearPoint> lowest;
  for (int i = 0; i < max_trials; ++i) {
    double part = right;
    if (i > 0) {
      const double secant = left + (right - left) * slope_left / (slope_left - slope_right),
                   margin = 0.1 * (right - left);
      const bool good = slope_right > 0 && i % 3 != 2;
      part = good ? std::clamp(secant, left + margin, right - margin) : 0.5 * (left + right);
    }
    const PatchPoint at{p.at.patch, clamped(p.at.s + part * step[0]), clamped(p.at.t + part * step[1])};
    if (at.s == p.at.s && at.t == p.at.t) break;
    const NearPoint q = this->at(at, t);
    const SurfacePoint x = surface_.patch(at.patch).at(at.s, at.t);
    const double slope = (q.motion.F.transpose() * q.gap.normal).dot(step[0] * x.by_s + step[1] * x.by_t);
    const bool low = q.gap.value <= p.gap.value + 1e-4 * part * slope0;
    if (low && (!lowest || q.gap.value < lowest->gap.value)) lowest = q;
    if (low && slope <= -0.5 * slope0) return lowest;
    if (low && slope <= 0)
      left = part, slope_left = slope;
    else
      right = part, slope_right = slope;
    if (right - left < 1e-15 * right) break;
  }
  return lowest;
}

NearPoint Descent::with_normal(NearPoint p, const Model& m, const Eigen::Vector2d& step) {
  const Vector3d n = p.gap.normal + m.turning * step;
  if (n.dot(p.gap.normal) > 0.5 && n.norm() < 2) p.normal = n.normalized();
  return p;
}

NearPoint Descent::nearest(const PatchPoint& start, double t) const { return nearest(start, t, infinity, 0); }

std::optional<NearPoint> Descent::by_support(const NearPoint& p, double t) const {
  const Vector3d w = p.motion.F.transpose() * p.gap.normal;
  const auto point = surface_.locate(support_point(surface_.shape(), -w));
  return point ? std::optional<NearPoint>(at(*point, t)) : std::nullopt;
}

NearPoint Descent::nearest(const PatchPoint& start, double t, double level, double tolerance) const {
  NearPoint p = newton(at(start, t), t, level, tolerance);
  for (int i = 0; i < max_supports; ++i) {
    const double rounding = eps * (p.motion.x.norm() + p.X.norm());
    const double enough = std::max(rounding, 1e-3 * std::max(tolerance, p.gap.value - level));
    const auto q = by_support(p, t);
    if (!q || !(q->gap.value < p.gap.value - enough)) break;
    p = newton(*q, t, level, tolerance);
  }
  return p;
}

NearPoint Descent::newton(NearPoint p, double t, double level, double tolerance) const {
  double least = infinity;  // of what steps promised
  for (int i = 0, crossings = 0; i < max_steps; ++i) {
    const Model m = model(p, t);
    if (crossings < max_crossings)
      if (const auto q = beyond(p, m)) {
        p = *q, ++crossings;
        continue;
      }
    const double least_bend = 1e-12 * m.steepness * m.size.maxCoeff();
    const Eigen::Vector2d step = projected_newton(p.at, m.slope, m.bend, least_bend);
    const double promise = -0.5 * m.slope.dot(step), rounding = 8 * eps * (p.motion.x.norm() + p.X.norm());
    if (!(promise > converged * std::max(tolerance, p.gap.value - level))) return with_normal(p, m, step);
    if (promise > rounding) {
      auto q = lower(p, m, step, t);
      // One parameter alone, where the other spoils the step.
      for (int a = 0; a < 2 && !(q && p.gap.value - q->gap.value > 0.1 * promise); ++a) {
        const auto alone = lower(p, m, step[a] * Eigen::Vector2d::Unit(a), t);
        if (alone && !(q && q->gap.value <= alone->gap.value)) q = alone;
      }
      if (!q) return with_normal(p, m, step);
      p = *q;
    } else {
      // Rounding hides the descent, but not the slope: on while Newton's steps shrink.
      const NearPoint q = at({p.at.patch, clamped(p.at.s + step[0]), clamped(p.at.t + step[1])}, t);
      if (!(promise < 0.25 * least && q.gap.value <= p.gap.value + rounding)) return with_normal(p, m, step);
      p = q;
    }
    least = std::min(least, promise);
  }
  return p;
}

}  // namespace mb
