#include "mechanics/contact/rigid_surface.h"

#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/signed_distance.h"

namespace mb {

namespace {

// The shape less its rounding on all sides.
Shape shrunk(const Shape& shape, double rounding) {
  if (!(rounding >= 0)) throw std::invalid_argument("rigid surface: the rounding is negative or not a number");
  const auto require_room = [&](double smallest) {
    if (!(2 * rounding < smallest))
      throw std::invalid_argument("rigid surface: the rounding is half the shape's smallest extent or more");
  };
  if (const auto* box = std::get_if<Box>(&shape)) {
    require_room(box->size.minCoeff());
    return Box{box->size - Vector3d::Constant(2 * rounding)};
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    require_room(std::min(2 * cylinder->radius, cylinder->length));
    return Cylinder{cylinder->radius - rounding, cylinder->length - 2 * rounding};
  }
  throw std::invalid_argument("rigid surface: only boxes and cylinders are rounded");
}

void require_valid(const RigidSurface& surface) {
  if (!(std::abs(surface.pose.orientation.squaredNorm() - 1) < 1e-9))
    throw std::invalid_argument("rigid surface: the orientation is not of unit length");
  if (std::holds_alternative<HalfSpace>(surface.shape) && surface.rounding != 0)
    throw std::invalid_argument("rigid surface: a half-space is not rounded");
}

}  // namespace

Gap gap(const RigidSurface& surface, const Vector3d& x) {
  require_valid(surface);
  const Vector3d X = surface.pose.to_frame(x);
  const Eigen::Matrix3d R = surface.pose.orientation.toRotationMatrix();
  const auto* shape = std::get_if<Shape>(&surface.shape);
  if (!shape) return {X[2], R.col(2), Eigen::Matrix3d::Zero()};
  const Distance d =
      surface.rounding == 0 ? signed_distance(*shape, X) : signed_distance(shrunk(*shape, surface.rounding), X);
  return {d.value - surface.rounding, R * d.gradient, R * d.hessian * R.transpose()};
}

double gap_value(const RigidSurface& surface, const Vector3d& x) {
  require_valid(surface);
  const Vector3d X = surface.pose.to_frame(x);
  const auto* shape = std::get_if<Shape>(&surface.shape);
  if (!shape) return X[2];
  if (surface.rounding == 0) return signed_distance_value(*shape, X);
  return signed_distance_value(shrunk(*shape, surface.rounding), X) - surface.rounding;
}

}  // namespace mb
