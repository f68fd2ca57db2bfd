#include "harness/analysis/contact_contest.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/analysis/layer_impact.h"
#include "mechanics/contact/first_touch_support.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/geometry/superquadric.h"
#include "mechanics/geometry/surface_patches.h"
#include "mechanics/geometry/triangulation.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

double error(double found, double exact) { return std::abs(found / exact - 1); }

void require_cells(int k) {
  if (k < 1 || k > 200) throw std::invalid_argument("contact contest: the number of cells is out of range");
}

HeightSamples heights(const PressedBody& body, const SurfacePoints& samples) {
  const Vector3d deepest = support_point(body.shape, body.down);
  return {-((samples.points.colwise() - deepest).transpose() * body.down), samples.weights};
}

// int sqrt(g) dA of a sphere's cap, int_0^delta sqrt(delta - h) 2 pi R dh: Hertz's force of the approach 2 delta but
// for 2 E*/pi sqrt(2/R) (plane_contact.h).
double root_moment(const Sphere& sphere, double depth) { return 4 * pi / 3 * sphere.radius * std::pow(depth, 1.5); }

}  // namespace

const std::vector<std::string>& contact_error_names() {
  static const std::vector<std::string> names{"force",   "area",       "greatest depth", "Hertz force",
                                              "impulse", "peak force", "duration"};
  return names;
}

VectorXd as_vector(const ContactErrors& e) {
  return VectorXd{{e.force, e.area, e.depth, e.hertz, e.impulse, e.peak, e.duration}};
}

PressedBody pressed_body(const Shape& shape, const Vector3d& down, double depth) {
  const PressedCap cap = pressed_cap(shape, down, depth);
  const auto law = [&](double d) { return pressed_cap(shape, down, d).contact; };
  return {shape, down.normalized(), cap, std::sqrt(2 * cap.contact.energy), time_to_rest(law, depth)};
}

SurfacePoints vertices_by_areas(const Shape& shape, int k) {
  require_cells(k);
  const TriangleMesh mesh = triangulate(shape, k);
  return {mesh.vertices, mesh.vertex_area};
}

SurfacePoints vertices_by_equal(const Shape& shape, int k) {
  const SurfacePoints all = vertices_by_areas(shape, k);
  return {all.points, VectorXd::Constant(all.weights.size(), all.weights.mean())};
}

SurfacePoints uniform_quadrature(const Shape& shape, int k) {
  require_cells(k);
  const std::vector<SurfacePatch> patches = surface_patches(shape);
  const Index n = static_cast<Index>(patches.size()) * k * k;
  SurfacePoints all{Matrix3Xd(3, n), VectorXd(n)};
  Index at = 0;
  for (const SurfacePatch& patch : patches)
    for (int i = 0; i < k; ++i)
      for (int j = 0; j < k; ++j, ++at) {
        const SurfacePoint p = patch.at((i + 0.5) / k, (j + 0.5) / k);
        all.points.col(at) = p.x;
        all.weights[at] = p.by_s.cross(p.by_t).norm() / k / k;
      }
  return all;
}

SurfacePoints region_quadrature(const PressedBody& body, Index n) {
  if (n < 24) throw std::invalid_argument("contact contest: fewer than 24 points in the region of contact");
  const Vector3d deepest = support_point(body.shape, body.down);
  const double largest = extent(body.shape), reach = body.cap.reach;
  const int edge = n < 100 ? 1 : 2;  // few points: one in each of up to 24 patches
  const auto rule = [&](double size) {
    const GradedRule found = graded_rule(body.shape, {deepest}, {size, 2 * largest, 0, edge}, reach);
    return SurfacePoints{found.points, found.weights};
  };
  double coarse = 2 * largest, fine = reach * std::sqrt(pi / static_cast<double>(n)) * edge / 2;
  SurfacePoints best = rule(coarse);
  for (int i = 0; i < 7; ++i) {
    const double size = std::sqrt(coarse * fine);
    SurfacePoints next = rule(size);
    const bool fits = next.weights.size() <= n;
    (fits ? coarse : fine) = size;
    if (fits && next.weights.size() >= best.weights.size()) best = std::move(next);
  }
  return best;
}

ContactErrors errors_of_samples(const PressedBody& body, const SurfacePoints& samples) {
  const PlaneContact& exact = body.cap.contact;
  const HeightSamples all = heights(body, samples);
  const PlaneContact found = all.at(exact.depth);
  const LayerImpact impact = impact_on_samples(all, body.speed, body.rest);
  const auto* sphere = std::get_if<Sphere>(&body.shape);
  return {error(found.force, exact.force),
          error(found.area, exact.area),
          error(found.depth, exact.depth),
          sphere ? error(all.root_moment(exact.depth), root_moment(*sphere, exact.depth)) : nan,
          error(impact.impulse, body.speed),
          error(impact.peak_force, exact.force),
          error(impact.duration, 2 * body.rest)};
}

ContactErrors errors_of_curvatures(const PressedBody& body) {
  const PlaneContact& exact = body.cap.contact;
  const Vector3d deepest = support_point(body.shape, body.down);
  Eigen::Vector2d k;
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
    k.setConstant(1 / sphere->radius);
  } else {
    k = principal_curvatures(std::get<Superquadric>(body.shape), deepest).values;
  }
  const PlaneContact found = contact_by_curvatures(k[0], k[1], exact.depth);
  ContactErrors all{error(found.force, exact.force), error(found.area, exact.area), 0, nan, 1, infinite, 1};
  if (std::holds_alternative<Sphere>(body.shape)) all.hertz = 0;  // Hertz's law is of curvatures
  if (!std::isfinite(found.force)) return all;  // flat: as hard as a wall, back at once with twice the impulse
  const LayerImpact impact = impact_on_square_law(found.force / (exact.depth * exact.depth), body.speed, body.rest);
  all.impulse = error(impact.impulse, body.speed);
  all.peak = error(impact.peak_force, exact.force);
  all.duration = error(impact.duration, 2 * body.rest);
  return all;
}

Matrix3Xd directions(int n) {
  if (n < 1) throw std::invalid_argument("directions: fewer than one");
  constexpr double golden = 0.6180339887498949;
  Matrix3Xd all(3, n);
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z), phi = 2 * pi * golden * i + 0.7;
    all.col(i) << r * std::cos(phi), r * std::sin(phi), z;
  }
  return all;
}

}  // namespace mb
