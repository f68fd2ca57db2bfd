#include "mechanics/rigid/inertia.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/tapered.h"

namespace mb {

namespace {

constexpr double rounding = 1e-12;   // [-] relative, what an input may be off by
constexpr double thinnest = 1e-100;  // [-] of moments: squares of ratios must not underflow

// Mean of x^2, y^2, z^2 over the shape [m^2].
Vector3d mean_squares(const Shape& shape) {
  return std::visit(overloaded{[](const Box& b) -> Vector3d { return b.size.cwiseAbs2() / 12; },
                               [](const Cylinder& c) {
                                 const double across = c.radius * c.radius / 4;
                                 return Vector3d(across, across, c.length * c.length / 12);
                               },
                               [](const Sphere& s) -> Vector3d { return Vector3d::Constant(s.radius * s.radius / 5); },
                               [](const auto& s) -> Vector3d {
                                 return Vector3d(moment(s, 2, 0, 0), moment(s, 0, 2, 0), moment(s, 0, 0, 2)) /
                                        moment(s, 0, 0, 0);
                               }},
                    shape);
}

double least_size(const Shape& shape) {
  return std::visit(
      overloaded{[](const Box& b) { return b.size.minCoeff(); },
                 [](const Cylinder& c) { return std::min(c.radius, c.length); },
                 [](const Sphere& s) { return s.radius; }, [](const Superquadric& s) { return s.semi_axes.minCoeff(); },
                 [](const TaperedSuperquadric& s) { return s.straight.semi_axes.minCoeff(); }},
      shape);
}

}  // namespace

MassProperties mass_properties(const Shape& shape, double density) {
  if (!(density > 0 && std::isfinite(density)))
    throw std::invalid_argument(fmt::format("mass_properties: density {} kg/m^3 is not positive and finite", density));
  const double least = least_size(shape), mass = density * volume(shape);
  const Vector3d s = mass * mean_squares(shape);
  if (!(least > 0 && mass > 0 && std::isfinite(mass) && s.allFinite()))
    throw std::invalid_argument(
        fmt::format("mass_properties: sizes must be positive and finite: smallest {} m, mass {} kg", least, mass));
  return {mass, Vector3d::Zero(), Vector3d(s[1] + s[2], s[2] + s[0], s[0] + s[1]).asDiagonal()};
}

void require_principal_moments(const Vector3d& moments, std::string_view where) {
  const double sum = moments.sum(), largest = moments.maxCoeff(), least = moments.minCoeff();
  if (!(least > 0 && least >= thinnest * largest) || !std::isfinite(sum))
    throw std::invalid_argument(fmt::format("{}: principal moments {}, {}, {} kg m^2 must be positive and finite",
                                            where, moments[0], moments[1], moments[2]));
  if (sum - largest < largest * (1 - rounding))
    throw std::invalid_argument(
        fmt::format("{}: of the principal moments {}, {}, {} kg m^2 one exceeds the sum of the others", where,
                    moments[0], moments[1], moments[2]));
}

PrincipalAxes principal_axes(const Eigen::Matrix3d& inertia) {
  const double size = inertia.cwiseAbs().maxCoeff();
  if (!inertia.allFinite() || !((inertia - inertia.transpose()).cwiseAbs().maxCoeff() <= rounding * size))
    throw std::invalid_argument("principal_axes: the inertia tensor is not finite or not symmetric");
  Eigen::Matrix3d J = 0.5 * (inertia + inertia.transpose()), axes = Eigen::Matrix3d::Identity();
  // Cyclic Jacobi converges quadratically; angles of at most 45 degrees keep the axes next to the body's.
  for (int sweep = 0; sweep < 30; ++sweep)
    for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
      Eigen::JacobiRotation<double> rotation;
      if (!rotation.makeJacobi(J, p, q)) continue;
      J.applyOnTheLeft(p, q, rotation.adjoint());
      J.applyOnTheRight(p, q, rotation);
      axes.applyOnTheRight(p, q, rotation);
      J(p, q) = J(q, p) = 0;
    }
  require_principal_moments(J.diagonal(), "principal_axes");
  return {J.diagonal(), Eigen::Quaterniond(axes).normalized()};
}

}  // namespace mb
