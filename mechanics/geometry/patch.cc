#include "mechanics/geometry/patch.h"

#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/graded_rule.h"

namespace mb {

double weight(const Patch& patch, const Vector3d& x) {
  if (!patch.disc) return 1;
  const double s = (x - patch.disc->centre).squaredNorm() / (patch.disc->radius * patch.disc->radius);
  return s < 1 ? (1 - s) * (1 - s) : 0;
}

namespace {

constexpr int n_rho = 8, n_theta = 24;  // w is a quadratic in rho^2: the rest is for shape functions, cell by cell

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
  return on_plane(c, plane_normal(shape, patch.face), rho, theta);
}

// Where a surface has no polar coordinates of its own: cells of a sixth of the radius, 3 x 3 points each.
DiscRule graded_disc_rule(const Shape& shape, const Patch& patch) {
  const double a = patch.disc->radius;
  const GradedRule rule = graded_rule(shape, {patch.disc->centre}, {a / 6, a / 6, 0, 3}, a);
  std::vector<Index> met;
  for (Index i = 0; i < rule.weights.size(); ++i)
    if (weight(patch, rule.points.col(i)) > 0) met.push_back(i);
  if (met.empty()) throw std::invalid_argument("nothing of the disc lies on face '" + patch.face + "'");
  VectorXd weights = rule.weights(met);
  for (Index i = 0; i < weights.size(); ++i) weights[i] *= weight(patch, rule.points.col(met[static_cast<size_t>(i)]));
  return {rule.points(Eigen::all, met), weights, rule.normals(Eigen::all, met)};
}

}  // namespace

DiscRule disc_rule(const Shape& shape, const Patch& patch) {
  if (!patch.disc) throw std::invalid_argument("disc_rule: the patch is a whole face");
  if (patch.face == "surface" && !std::holds_alternative<Sphere>(shape)) return graded_disc_rule(shape, patch);
  const double a = patch.disc->radius;
  const Rule radial = gauss_legendre(n_rho);
  DiscRule rule{Matrix3Xd(3, n_rho * n_theta), VectorXd(n_rho * n_theta), Matrix3Xd(3, n_rho * n_theta)};
  Index n = 0;
  for (int i = 0; i < n_rho; ++i)
    for (int j = 0; j < n_theta; ++j) {
      const FacePoint p = face_point(shape, patch, a * std::sqrt(radial.x[i]), 2 * pi * (j + 0.5 * (i % 2)) / n_theta);
      if (!contains(shape, p.x, 1e-9 * extent(shape))) continue;
      rule.points.col(n) = p.x;
      rule.normals.col(n) = p.normal;
      rule.weights[n++] = weight(patch, p.x) * p.stretch * pi * a * a * radial.w[i] / n_theta;
    }
  if (!(rule.weights.head(n).sum() > 0))
    throw std::invalid_argument("nothing of the disc lies on face '" + patch.face + "'");
  return {rule.points.leftCols(n), rule.weights.head(n), rule.normals.leftCols(n)};
}

}  // namespace mb
