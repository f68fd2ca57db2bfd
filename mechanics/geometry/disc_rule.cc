#include "mechanics/geometry/disc_rule.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/graded_rule.h"

namespace mb {

namespace {

constexpr int most_rings = 128;
int number_of_rings(double length, double spacing, int fewest) {
  return static_cast<int>(std::clamp(std::ceil(length / spacing), 1.0 * fewest, 1.0 * most_rings));
}

struct FacePoint {
  Vector3d x, normal;
  double stretch;  // dA / (rho drho dtheta)
};

// A direction across n, as near to the z axis as there is (to x where n is z).
Vector3d across(const Vector3d& n) {
  const Vector3d axis = std::abs(n[2]) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitX();
  return (axis - axis.dot(n) * n).normalized();
}

FacePoint on_plane(const Vector3d& c, const Vector3d& n, double rho, double theta) {
  const Vector3d e = across(n);
  return {c + rho * (std::cos(theta) * e + std::sin(theta) * n.cross(e)), n, 1};
}

// Chord rho spans the angle 2 asin(rho / 2R); Archimedes: a cap's area is pi rho^2.
FacePoint on_sphere(const Vector3d& c, double R, double rho, double theta) {
  const Vector3d n = c.normalized(), e = across(n);
  const double angle = 2 * std::asin(std::min(1.0, rho / (2 * R)));
  const Vector3d normal = std::cos(angle) * n + std::sin(angle) * (std::cos(theta) * e + std::sin(theta) * n.cross(e));
  return {R * normal, normal, 1};
}

FacePoint on_side(const Vector3d& c, double R, double rho, double theta) {
  const double half = std::min(1.0, rho * std::abs(std::cos(theta)) / (2 * R));
  const double phi = std::atan2(c[1], c[0]) + std::copysign(2 * std::asin(half), std::cos(theta));
  const Vector3d normal(std::cos(phi), std::sin(phi), 0);
  return {R * normal + (c[2] + rho * std::sin(theta)) * Vector3d::UnitZ(), normal,
          half < 1 ? 1 / std::sqrt(1 - half * half) : 0};
}

FacePoint face_point(const Shape& shape, const Patch& patch, double rho, double theta) {
  const Vector3d& c = patch.disc->centre;
  if (patch.face == "surface") return on_sphere(c, std::get<Sphere>(shape).radius, rho, theta);
  if (patch.face == "side") return on_side(c, std::get<Cylinder>(shape).radius, rho, theta);
  const Vector3d n = plane_normal(shape, patch.face);
  return on_plane(c - face_distance(shape, patch.face, c) * n, n, rho, theta);  // a centre may be off by rounding
}

// Where a surface has no polar coordinates of its own: cells of three points' length and 3 x 3 points each.
DiscRule graded_disc_rule(const Shape& shape, const Patch& patch, double spacing) {
  const double a = patch.disc->radius, cell = 4 * a / (3 * number_of_rings(a, spacing, 8));
  const GradedRule rule = graded_rule(shape, {patch.disc->centre}, {cell, cell, 0, 3}, a);
  std::vector<Index> met;
  for (Index i = 0; i < rule.weights.size(); ++i)
    if (weight(patch, rule.points.col(i)) > 0) met.push_back(i);
  if (met.empty()) throw std::invalid_argument("nothing of the disc lies on face '" + patch.face + "'");
  VectorXd weights = rule.weights(met);
  for (Index i = 0; i < weights.size(); ++i) weights[i] *= weight(patch, rule.points.col(met[static_cast<size_t>(i)]));
  return {rule.points(Eigen::all, met), weights, rule.normals(Eigen::all, met)};
}

using OnFace = std::function<bool(double rho, double theta)>;
struct Arc {
  double begin, end;  // [rad] a whole ring: 2 pi apart
};

// The arcs of a ring that lie on the face, to 1e-15. Shorter ones than 2 pi/192 are not seen.
std::vector<Arc> arcs(const OnFace& on_face, double rho) {
  constexpr int n = 192;
  const auto direction = [](int k) { return 2 * pi * (k + 0.5) / n; };
  const auto change = [&](double from, double to) {
    const bool before = on_face(rho, from);
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = (from + to) / 2;
      (on_face(rho, middle) == before ? from : to) = middle;
    }
    return to;
  };
  std::vector<double> begins, ends;
  bool before = on_face(rho, direction(-1));
  for (int k = 0; k < n; ++k) {
    const bool here = on_face(rho, direction(k));
    if (here != before) (here ? begins : ends).push_back(change(direction(k - 1), direction(k)));
    before = here;
  }
  if (begins.empty()) return before ? std::vector<Arc>{{0, 2 * pi}} : std::vector<Arc>{};
  std::vector<Arc> result;
  for (const double begin : begins) {  // begins and ends take turns; the last arc may end beyond 2 pi
    const auto end = std::ranges::find_if(ends, [&](double e) { return e > begin; });
    result.push_back({begin, end == ends.end() ? ends.front() + 2 * pi : *end});
  }
  return result;
}

struct Ring {
  double rho, weight;  // [m], [m^2] rho drho
};

// w and moments are polynomials in rho^2 all round.
std::vector<Ring> whole_rings(double a, double spacing) {
  const Rule rule = gauss_legendre(number_of_rings(a, spacing, 8));
  std::vector<Ring> rings;
  for (Index i = 0; i < rule.x.size(); ++i) rings.push_back({a * std::sqrt(rule.x[i]), a * a / 2 * rule.w[i]});
  return rings;
}

// Arcs grow like a root from the radius at which a rim is touched: rho = lo + (hi - lo) (3 t^2 - 2 t^3) between those
// radii makes that smooth, and polynomials up to rho^6 are exact.
std::vector<Ring> cut_rings(const std::vector<double>& radii, double spacing) {
  std::vector<Ring> rings;
  for (size_t k = 1; k < radii.size(); ++k) {
    const double lo = radii[k - 1], length = radii[k] - lo;
    const Rule rule = gauss_legendre(number_of_rings(1.5 * length, spacing, 12));
    for (Index i = 0; i < rule.x.size(); ++i) {
      const double t = rule.x[i], rho = lo + length * t * t * (3 - 2 * t);
      rings.push_back({rho, rho * length * 6 * t * (1 - t) * rule.w[i]});
    }
  }
  return rings;
}

constexpr int whole = -1;
int number_of_arcs(const OnFace& on_face, double rho) {
  const std::vector<Arc> here = arcs(on_face, rho);
  return here.size() == 1 && here[0].end - here[0].begin == 2 * pi ? whole : static_cast<int>(here.size());
}

// 0, the radii at which the number of arcs changes, and a.
std::vector<double> radii_of_change(const OnFace& on_face, double a) {
  constexpr int n = 64;
  std::vector<double> radii{0};
  const double least = 1e-6 * a;
  int before = number_of_arcs(on_face, least);
  for (int k = 0; k < n; ++k) {
    double from = std::max(least, (k - 0.5) * a / n), to = (k + 0.5) * a / n;
    const int here = number_of_arcs(on_face, to);
    if (here == before) continue;
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = (from + to) / 2;
      (number_of_arcs(on_face, middle) == before ? from : to) = middle;
    }
    radii.push_back(to);
    before = here;
  }
  radii.push_back(a);
  return radii;
}

std::vector<Ring> rings(const OnFace& on_face, double a, double spacing) {
  const std::vector<double> radii = radii_of_change(on_face, a);
  const bool is_whole = radii.size() == 2 && number_of_arcs(on_face, a / 2) == whole;
  return is_whole ? whole_rings(a, spacing) : cut_rings(radii, spacing);
}

// Angles [rad] of a ring's points, weights that sum to the angle on the face: equally spaced all round, by `first` of
// their distance on, else Gauss's on each arc.
Rule ring_rule(const std::vector<Arc>& arcs, int n, double first) {
  Rule rule;
  for (const auto& [begin, end] : arcs) {
    const double angle = end - begin;
    const bool all_round = angle == 2 * pi;
    const int m = all_round ? n : std::max(4, static_cast<int>(std::ceil(n * angle / (2 * pi))));
    const Rule arc = all_round
                         ? Rule{(VectorXd::LinSpaced(n, 0, n - 1).array() + first) / n, VectorXd::Constant(n, 1.0 / n)}
                         : gauss_legendre(m);
    const Index before = rule.x.size();
    rule.x.conservativeResize(before + m);
    rule.w.conservativeResize(before + m);
    rule.x.tail(m) = begin + angle * arc.x.array();
    rule.w.tail(m) = angle * arc.w;
  }
  return rule;
}

DiscRule disc_rule_of(const std::vector<FacePoint>& points, const std::vector<double>& weights) {
  const auto n = static_cast<Index>(points.size());
  DiscRule rule{Matrix3Xd(3, n), Eigen::Map<const VectorXd>(weights.data(), n), Matrix3Xd(3, n)};
  for (Index i = 0; i < n; ++i) {
    rule.points.col(i) = points[static_cast<size_t>(i)].x;
    rule.normals.col(i) = points[static_cast<size_t>(i)].normal;
  }
  return rule;
}

}  // namespace

DiscRule disc_rule(const Shape& shape, const Patch& patch, double spacing) {
  if (!patch.disc) throw std::invalid_argument("disc_rule: the patch is a whole face");
  if (!(spacing > 0)) throw std::invalid_argument("disc_rule: the spacing must be > 0");
  if (patch.face == "surface" && !std::holds_alternative<Sphere>(shape)) return graded_disc_rule(shape, patch, spacing);
  const double a = patch.disc->radius, tolerance = 1e-12 * extent(shape);
  const auto at = [&](double rho, double theta) { return face_point(shape, patch, rho, theta); };
  const OnFace on_face = [&](double rho, double theta) { return contains(shape, at(rho, theta).x, tolerance); };
  const int n_theta = 3 * number_of_rings(a, spacing, 8);  // as far apart as rings are, half-way out
  std::vector<FacePoint> points;
  std::vector<double> weights;
  double first = 0;
  for (const auto& [rho, area] : rings(on_face, a, spacing)) {
    const Rule ring = ring_rule(arcs(on_face, rho), n_theta, first);
    for (Index j = 0; j < ring.x.size(); ++j) {
      points.push_back(at(rho, ring.x[j]));
      weights.push_back(weight(patch, points.back().x) * points.back().stretch * area * ring.w[j]);
    }
    first = 0.5 - first;  // every other ring turned by half a distance
  }
  if (!(std::accumulate(weights.begin(), weights.end(), 0.0) > 0))
    throw std::invalid_argument("nothing of the disc lies on face '" + patch.face + "'");
  return disc_rule_of(points, weights);
}

}  // namespace mb
