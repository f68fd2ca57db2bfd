#include "mechanics/contact/first_touch_support.h"

#include <cmath>

#include "mechanics/geometry/dual_norm.h"
#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/tapered.h"

namespace mb {

namespace {

double side(double w) { return w < 0 ? -1 : 1; }

// w / |w| where squares would over- or underflow, too; a of w = 0.
template <class Vector>
Vector direction(const Vector& w, const Vector& a) {
  const double largest = w.cwiseAbs().maxCoeff();
  if (largest > 1e-120 && largest < 1e120) return w / w.norm();
  return largest > 0 ? (w / largest).normalized() : a;
}

Vector3d farthest(const Superquadric& body, const Vector3d& w) {
  const Vector3d scaled = body.semi_axes.cwiseProduct(w.cwiseAbs());
  const double largest = scaled.maxCoeff();
  if (!(largest > 0)) return {0, 0, body.semi_axes[2]};
  const Vector3d u = scaled / largest;
  const Eigen::Vector2d across = std::max(u[0], u[1]) > 0 ? dual_gradient(u[0], u[1], body.e2) : Eigen::Vector2d(1, 0);
  const Eigen::Vector2d along = dual_gradient(across[0] * u[0] + across[1] * u[1], u[2], body.e1);
  const Vector3d X(along[0] * across[0], along[0] * across[1], along[1]);
  return body.semi_axes.cwiseProduct(X).cwiseProduct(w.unaryExpr(&side));
}

}  // namespace

Vector3d support_point(const Shape& shape, const Vector3d& w) {
  return std::visit(
      overloaded{[&](const Box& b) -> Vector3d { return 0.5 * b.size.cwiseProduct(w.unaryExpr(&side)); },
                 [&](const Cylinder& c) -> Vector3d {
                   const Eigen::Vector2d across =
                       c.radius * direction<Eigen::Vector2d>(w.head<2>(), Eigen::Vector2d::UnitX());
                   return {across[0], across[1], 0.5 * c.length * side(w[2])};
                 },
                 [&](const Sphere& s) -> Vector3d { return s.radius * direction<Vector3d>(w, Vector3d::UnitZ()); },
                 [&](const Superquadric& s) { return farthest(s, w); },
                 [&](const TaperedSuperquadric& s) { return farthest(s, w); }},
      shape);
}

std::optional<Vector3d> support_point(const RigidSurface& obstacle, const Vector3d& w) {
  const auto* shape = std::get_if<Shape>(&obstacle.shape);
  if (!shape) return std::nullopt;
  const Vector3d direction = obstacle.pose.orientation.conjugate() * w;
  Vector3d X = support_point(*shape, direction);
  // A ball of the rounding's radius along the shape less it on all sides.
  const double r = obstacle.rounding, length = direction.norm();
  if (r > 0 && length > 0) {
    const Vector3d n = direction / length;
    if (std::holds_alternative<Box>(*shape))
      X += r * (n - n.unaryExpr(&side));
    else if (std::holds_alternative<Cylinder>(*shape))
      X += r * (n - Vector3d(X[0], X[1], 0) / X.head<2>().norm() - side(n[2]) * Vector3d::UnitZ());
  }
  return obstacle.pose.to_world(X);
}

double circumradius(const Shape& shape) {
  return std::visit(
      overloaded{[](const Box& b) { return 0.5 * b.size.norm(); },
                 [](const Cylinder& c) { return std::hypot(c.radius, 0.5 * c.length); },
                 [](const Sphere& s) { return s.radius; }, [](const Superquadric& s) { return s.semi_axes.norm(); },
                 [](const TaperedSuperquadric& s) {
                   const Eigen::AlignedBox3d box = bounds(s);
                   return box.min().cwiseAbs().cwiseMax(box.max()).norm();
                 }},
      shape);
}

}  // namespace mb
