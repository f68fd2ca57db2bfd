#include "mechanics/geometry/surface_patches.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/superquadric.h"

namespace mb {

namespace {

constexpr double square = 0.6;  // half diagonal of an end's square by the radius: blocks of about equal size
constexpr double quarter_turn = pi / 2;

Vector3d circle(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

SurfacePoint point(const SurfacePatch::Rectangle& r, double s, double t) {
  return {r.origin + s * r.a + t * r.b, r.a, r.b};
}

SurfacePoint point(const SurfacePatch::Side& side, double s, double t) {
  const auto& [R, L] = side.cylinder;
  const Vector3d n = circle((side.quarter + s - 0.5) * quarter_turn);
  return {R * n + L * (t - 0.5) * Vector3d::UnitZ(), R * quarter_turn * Vector3d(-n[1], n[0], 0),
          L * Vector3d::UnitZ()};
}

// A block of the unit disc, seen from above: r from the square's edge to the rim, c counter-clockwise.
SurfacePoint disc_block(int block, double r, double c) {
  if (block == 4) {
    const double h = square * std::sqrt(0.5);
    return {{h * (2 * r - 1), h * (2 * c - 1), 0}, {2 * h, 0, 0}, {0, 2 * h, 0}};
  }
  const Vector3d from = square * circle((block - 0.5) * quarter_turn);
  const Vector3d to = square * circle((block + 0.5) * quarter_turn);
  const Vector3d edge = (1 - c) * from + c * to, rim = circle((block + c - 0.5) * quarter_turn);
  return {(1 - r) * edge + r * rim, rim - edge,
          (1 - r) * (to - from) + r * quarter_turn * Vector3d(-rim[1], rim[0], 0)};
}

SurfacePoint point(const SurfacePatch::EndBlock& end, double s, double t) {
  const auto& [R, L] = end.cylinder;
  const SurfacePoint p = end.upper ? disc_block(end.block, s, t) : disc_block(end.block, t, s);
  const Vector3d x = R * p.x + (end.upper ? 0.5 : -0.5) * L * Vector3d::UnitZ();
  return end.upper ? SurfacePoint{x, R * p.by_s, R * p.by_t} : SurfacePoint{x, R * p.by_t, R * p.by_s};
}

// g, homogeneous of degree one and 1 on the surface, and its gradient [1/m].
struct Gauge {
  double value;
  Vector3d gradient;
};

Gauge gauge_of(const Sphere& sphere, const Vector3d& u) {
  const Vector3d v = u / sphere.radius;
  const double g = v.norm();
  return {g, v / (g * sphere.radius)};
}

Gauge gauge_of(const Superquadric& body, const Vector3d& u) {
  const GaugeDerivatives g = gauge_derivatives(body, u);
  return {g.value, g.gradient};
}

Gauge gauge_of(const SurfacePatch::Radial& radial, const Vector3d& u) {
  return std::visit([&](const auto& body) { return gauge_of(body, u); }, radial.body);
}

double gauge_value(const SurfacePatch::Radial& radial, const Vector3d& u) {
  return std::visit(overloaded{[&](const Sphere& sphere) { return (u / sphere.radius).norm(); },
                               [&](const Superquadric& body) { return gauge(body, u); }},
                    radial.body);
}

// A point u of the circumscribed box's face, and its derivatives.
SurfacePoint on_box(const SurfacePatch::Radial& radial, double s, double t) {
  const ParameterCell& range = radial.range;
  const double ds = range.s1 - range.s0, dt = range.t1 - range.t0;
  const double a = std::tan(pi / 4 * (2 * (range.s0 + s * ds) - 1));
  const double b = std::tan(pi / 4 * (2 * (range.t0 + t * dt) - 1));
  const Eigen::Matrix3d& axes = radial.axes;
  return {axes * Vector3d(a, b, 1), quarter_turn * ds * (1 + a * a) * axes.col(0),
          quarter_turn * dt * (1 + b * b) * axes.col(1)};
}

SurfacePoint point(const SurfacePatch::Radial& radial, double s, double t) {
  const SurfacePoint u = on_box(radial, s, t);
  const Gauge g = gauge_of(radial, u.x);
  const Vector3d x = u.x / g.value;
  const Vector3d by_s = (u.by_s - x * g.gradient.dot(u.by_s)) / g.value;
  const Vector3d by_t = (u.by_t - x * g.gradient.dot(u.by_t)) / g.value;
  if (!radial.taper) return {x, by_s, by_t};
  const Eigen::Matrix3d F = radial.taper->gradient(x);
  return {radial.taper->apply(x), F * by_s, F * by_t};
}

using Corners = std::array<Vector3d, 4>;

double farthest(const Corners& corners, const Vector3d& x) {
  double d = 0;
  for (const Vector3d& c : corners) d = std::max(d, (c - x).norm());
  return d;
}

template <class Map>
auto at_corners(const Map& map, const ParameterCell& c) {
  return std::array{map(c.s0, c.t0), map(c.s1, c.t0), map(c.s1, c.t1), map(c.s0, c.t1)};
}

template <class Kind>
Corners corner_points(const Kind& kind, const ParameterCell& cell) {
  return at_corners([&](double s, double t) -> Vector3d { return point(kind, s, t).x; }, cell);
}

// Affine: a corner is the farthest point. On the side, too, since |x - x'|^2 = 4 R^2 sin^2(dphi/2) + dz^2.
template <class Kind>
double reach(const Kind& kind, const ParameterCell& cell, const Vector3d& x) {
  return farthest(corner_points(kind, cell), x);
}

// A map differs from the bilinear one through its corners, whose points are means of these, by h^2/8 max |x_tt| at most
// where it is linear in s; here |x_tt| <= s R (pi/2)^2.
double reach(const SurfacePatch::EndBlock& end, const ParameterCell& cell, const Vector3d& x) {
  const double across = end.upper ? cell.s1 : cell.t1;
  const double h = quarter_turn * (end.upper ? cell.t1 - cell.t0 : cell.s1 - cell.s0);
  return farthest(corner_points(end, cell), x) + (end.block < 4 ? across * end.cylinder.radius * h * h / 8 : 0);
}

// The body is convex: along each ray of the cell the surface lies between the triangles of the corners' points and any
// plane that supports the body. Both are met by the rays in the convex hull of four points, so one of these is the
// farthest. Planes: the box's face, and the tangent plane at x, n . y = 1 with n = grad g, if all the rays meet it.
// length(y - x) [m], a norm.
template <class Norm>
double straight_reach(const SurfacePatch::Radial& radial, const ParameterCell& cell, const Vector3d& x,
                      const Norm& length) {
  const Corners box = at_corners([&](double s, double t) -> Vector3d { return on_box(radial, s, t).x; }, cell);
  const Vector3d n = gauge_of(radial, x).gradient;
  double inner = 0, outer = 0, of_box = 0;
  for (const Vector3d& u : box) {
    inner = std::max(inner, length(u / gauge_value(radial, u) - x));
    const double height = n.dot(u);
    outer = std::max(outer, height > 0 ? length(u / height - x) : std::numeric_limits<double>::infinity());
    of_box = std::max(of_box, length(u - x));
  }
  return std::max(inner, std::min(outer, of_box));
}

// A taper takes y - x to F (y - x) + k/a3 (y_z - x_z) (y - x across z), F its gradient at x: of the linear part the
// same points are the farthest, the other is at most |k|/2a3 |y - x|^2.
double reach(const SurfacePatch::Radial& radial, const ParameterCell& cell, const Vector3d& x) {
  const auto norm = [](const Vector3d& d) { return d.norm(); };
  if (!radial.taper) return straight_reach(radial, cell, x, norm);
  const Vector3d X = radial.taper->inverse(x);
  const Eigen::Matrix3d F = radial.taper->gradient(X);
  const double r = straight_reach(radial, cell, X, norm);
  return straight_reach(radial, cell, X, [&](const Vector3d& d) { return (F * d).norm(); }) +
         0.5 * std::abs(radial.taper->rate()) * r * r;
}

// Squares of lengths stay within the range of doubles.
void require_length(double length, const char* what) {
  if (!(length >= 1e-100 && length <= 1e100))
    throw std::invalid_argument(fmt::format("surface_patches: {} is {} m, range 1e-100 to 1e100 m", what, length));
}

// Right-handed axes along x, y, z whose third points out of the face: -x, +x, -y, ...
Eigen::Matrix3d face_axes(int face) {
  const int axis = face / 2;
  Vector3d e1 = Vector3d::Unit((axis + 1) % 3), e2 = Vector3d::Unit((axis + 2) % 3);
  if (face % 2 == 0) std::swap(e1, e2);
  return (Eigen::Matrix3d() << e1, e2, (face % 2 ? 1.0 : -1.0) * Vector3d::Unit(axis)).finished();
}

std::vector<SurfacePatch> patches(const Box& box) {
  for (int i = 0; i < 3; ++i) require_length(box.size[i], "an edge of the box");
  std::vector<SurfacePatch> list;
  for (int face = 0; face < 6; ++face) {
    const Eigen::Matrix3d axes = box.size.asDiagonal() * face_axes(face);
    const Vector3d origin = 0.5 * (axes.col(2) - axes.col(0) - axes.col(1));
    list.emplace_back(SurfacePatch::Rectangle{origin, axes.col(0), axes.col(1)});
  }
  return list;
}

std::vector<SurfacePatch> patches(const Cylinder& cylinder) {
  require_length(cylinder.radius, "the cylinder's radius");
  require_length(cylinder.length, "the cylinder's length");
  std::vector<SurfacePatch> list;
  list.reserve(14);
  for (int quarter = 0; quarter < 4; ++quarter) list.emplace_back(SurfacePatch::Side{cylinder, quarter});
  for (const bool upper : {false, true})
    for (int block = 0; block < 5; ++block) list.emplace_back(SurfacePatch::EndBlock{cylinder, block, upper});
  return list;
}

std::vector<SurfacePatch> patches(const Sphere& sphere) {
  require_length(sphere.radius, "the sphere's radius");
  std::vector<SurfacePatch> list;
  list.reserve(6);
  for (int face = 0; face < 6; ++face)
    list.emplace_back(SurfacePatch::Radial{sphere, sphere.radius * face_axes(face), {}, {}});
  return list;
}

std::vector<SurfacePatch> patches(const Superquadric& body, const std::optional<Taper>& taper = {}) {
  for (int i = 0; i < 3; ++i) require_length(body.semi_axes[i], "a semi-axis of the superquadric");
  gauge(body, body.semi_axes);  // throws where the exponents are out of range
  std::vector<SurfacePatch> list;
  for (int face = 0; face < 6; ++face) {
    const Eigen::Matrix3d axes = body.semi_axes.asDiagonal() * face_axes(face);
    for (const double s : {0.0, 0.5})
      for (const double t : {0.0, 0.5})
        list.emplace_back(SurfacePatch::Radial{body, axes, {s, s + 0.5, t, t + 0.5}, taper});
  }
  return list;
}

std::vector<SurfacePatch> patches(const TaperedSuperquadric& body) { return patches(body.straight, Taper(body)); }

}  // namespace

SurfacePoint SurfacePatch::at(double s, double t) const {
  return std::visit([&](const auto& kind) { return point(kind, s, t); }, kind_);
}

double SurfacePatch::covering_radius(const ParameterCell& cell, double s, double t) const {
  constexpr double slack = 8 * std::numeric_limits<double>::epsilon();  // rounding of the points, each of a few units
  return std::visit(
      [&](const auto& kind) {
        const Vector3d x = point(kind, s, t).x;
        const double radius = reach(kind, cell, x);
        return radius + slack * (radius + x.norm());
      },
      kind_);
}

std::vector<SurfacePatch> surface_patches(const Shape& shape) {
  return std::visit([](const auto& s) { return patches(s); }, shape);
}

}  // namespace mb
