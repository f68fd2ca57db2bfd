#include "mechanics/geometry/signed_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/superquadric_distance.h"
#include "mechanics/geometry/tapered_distance.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double least_radius = 1e-9;  // of curvature, relative to the extent

void require_positive(double size, const char* what) {
  if (!(size > 0)) throw std::invalid_argument(std::string("signed_distance: ") + what + " is not positive");
}

// |v| where squares would over- or underflow, too; and v / |v|, of v not 0.
template <class Vector>
double length(const Vector& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (largest == 0 || (largest > 1e-120 && largest < 1e120)) return v.norm();
  return largest * (v / largest).norm();
}
template <class Vector>
Vector direction(const Vector& v) {
  return (v / v.cwiseAbs().maxCoeff()).normalized();
}

double side(double x) { return x < 0 ? -1 : 1; }

double inverse_radius(double radius, double extent) { return 1 / std::max(radius, least_radius * extent); }

// Of the set q <= 0 from the point q: max q inside, |max(q, 0)| outside.
template <class Vector>
double corner_value(const Vector& q) {
  const double greatest = q.maxCoeff();
  return greatest <= 0 ? greatest : length(Vector(q.cwiseMax(0)));
}

// The same with its gradient, of the first of equal coordinates inside.
template <class Vector>
struct CornerDistance {
  double value;
  Vector gradient;
};
template <class Vector>
CornerDistance<Vector> corner_distance(const Vector& q) {
  Index first;
  const double greatest = q.maxCoeff(&first);
  if (greatest <= 0) return {greatest, Vector::Unit(first)};
  const Vector beyond = q.cwiseMax(0);
  return {length(beyond), direction(beyond)};
}

Distance distance(const Box& box, const Vector3d& x) {
  const Vector3d q = x.cwiseAbs() - 0.5 * box.size;
  const auto [value, gradient] = corner_distance(q);
  const Vector3d n = gradient.cwiseProduct(x.unaryExpr(&side));
  if (value <= 0 || (q.array() > 0).count() == 1) return {value, n, Eigen::Matrix3d::Zero()};
  // About an edge or a corner: the directions in which x is outside, less the normal.
  Eigen::Matrix3d H = -n * n.transpose();
  for (int i = 0; i < 3; ++i) H(i, i) += q[i] > 0 ? 1 : 0;
  return {value, n, inverse_radius(value, box.size.maxCoeff()) * H};
}

double value(const Box& box, const Vector3d& x) { return corner_value(Vector3d(x.cwiseAbs() - 0.5 * box.size)); }

// In the half plane (rho, z) a rectangle's distance; the circumference adds the curvature n_rho / rho.
Distance distance(const Cylinder& c, const Vector3d& x) {
  const Eigen::Vector2d across = x.head<2>();
  const double rho = length(across), extent = std::max(2 * c.radius, c.length);
  Vector3d radial = Vector3d::UnitX();
  if (rho > 0) radial.head<2>() = direction(across);
  const Eigen::Vector2d q(rho - c.radius, std::abs(x[2]) - 0.5 * c.length);
  const auto [value, n] = corner_distance(q);
  const double n_z = n[1] * side(x[2]);
  const Vector3d normal = n[0] * radial + n_z * Vector3d::UnitZ();
  const Vector3d around(-radial[1], radial[0], 0), along = -n_z * radial + n[0] * Vector3d::UnitZ();
  Eigen::Matrix3d H = n[0] * inverse_radius(rho, extent) * around * around.transpose();
  if (q.minCoeff() > 0) H += inverse_radius(value, extent) * along * along.transpose();  // about the rim
  return {value, normal, H};
}

double value(const Cylinder& c, const Vector3d& x) {
  return corner_value(
      Eigen::Vector2d(length(Eigen::Vector2d(x.head<2>())) - c.radius, std::abs(x[2]) - 0.5 * c.length));
}

Distance distance(const Sphere& s, const Vector3d& x) {
  const double r = length(x);
  const Vector3d n = r > 0 ? direction(x) : Vector3d::UnitZ();
  return {r - s.radius, n, inverse_radius(r, 2 * s.radius) * (Eigen::Matrix3d::Identity() - n * n.transpose())};
}

double value(const Sphere& s, const Vector3d& x) { return length(x) - s.radius; }

Distance distance(const Superquadric& s, const Vector3d& x) { return superquadric_distance(s, x); }
double value(const Superquadric& s, const Vector3d& x) { return superquadric_distance_value(s, x); }
Distance distance(const TaperedSuperquadric& s, const Vector3d& x) { return tapered_distance(s, x); }
double value(const TaperedSuperquadric& s, const Vector3d& x) { return tapered_distance(s, x).value; }

void require_valid(const Shape& shape) {
  std::visit(overloaded{[](const Box& b) {
                          for (const double edge : b.size) require_positive(edge, "a box's edge");
                        },
                        [](const Cylinder& c) {
                          require_positive(c.radius, "a cylinder's radius");
                          require_positive(c.length, "a cylinder's length");
                        },
                        [](const Sphere& s) { require_positive(s.radius, "a sphere's radius"); },
                        [](const auto&) {}},  // superquadrics see to it themselves
             shape);
}

}  // namespace

Distance signed_distance(const Shape& shape, const Vector3d& x) {
  require_valid(shape);
  if (!x.allFinite()) return {nan, Vector3d::Constant(nan), Eigen::Matrix3d::Constant(nan)};
  return std::visit([&](const auto& s) { return distance(s, x); }, shape);
}

double signed_distance_value(const Shape& shape, const Vector3d& x) {
  require_valid(shape);
  if (!x.allFinite()) return nan;
  return std::visit([&](const auto& s) { return value(s, x); }, shape);
}

}  // namespace mb
