#include "mechanics/geometry/shape.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/signed_distance.h"
#include "mechanics/geometry/superquadric.h"
#include "mechanics/geometry/tapered.h"

namespace mb {

double volume(const Shape& shape) {
  return std::visit(overloaded{[](const Box& b) { return b.size.prod(); },
                               [](const Cylinder& c) { return pi * c.radius * c.radius * c.length; },
                               [](const Sphere& s) { return 4.0 / 3.0 * pi * s.radius * s.radius * s.radius; },
                               [](const Superquadric& s) { return moment(s, 0, 0, 0); },
                               [](const TaperedSuperquadric& s) { return moment(s, 0, 0, 0); }},
                    shape);
}

Vector3d extents(const Shape& shape) {
  return std::visit(overloaded{[](const Box& b) -> Vector3d { return b.size; },
                               [](const Cylinder& c) { return Vector3d(2 * c.radius, 2 * c.radius, c.length); },
                               [](const Sphere& s) -> Vector3d { return Vector3d::Constant(2 * s.radius); },
                               [](const Superquadric& s) -> Vector3d { return 2 * s.semi_axes; },
                               [](const TaperedSuperquadric& s) -> Vector3d { return bounds(s).sizes(); }},
                    shape);
}

double extent(const Shape& shape) { return extents(shape).maxCoeff(); }

std::vector<std::string> face_names(const Shape& shape) {
  return std::visit(overloaded{[](const Box&) -> std::vector<std::string> {
                                 return {"x-min", "x-max", "y-min", "y-max", "z-min", "z-max"};
                               },
                               [](const Cylinder&) -> std::vector<std::string> {
                                 return {"side", "z-min", "z-max"};
                               },
                               [](const auto&) -> std::vector<std::string> { return {"surface"}; }},
                    shape);
}

namespace {

struct AxisFace {
  int axis;
  double sign;
};

// "y-max" -> {1, +1}; the name is known to be one of the shape's plane faces.
AxisFace axis_face(const std::string& face) { return {face[0] - 'x', face.ends_with("max") ? 1.0 : -1.0}; }

void require_face(const Shape& shape, const std::string& face) {
  const auto names = face_names(shape);
  if (std::find(names.begin(), names.end(), face) == names.end())
    throw std::invalid_argument("unknown face '" + face + "'");
}

// Of a shape with plane faces across the axis.
double half_length(const Shape& shape, int axis) {
  if (const auto* box = std::get_if<Box>(&shape)) return 0.5 * box->size[axis];
  return 0.5 * std::get<Cylinder>(shape).length;
}

}  // namespace

bool is_plane(const Shape& shape, const std::string& face) {
  require_face(shape, face);
  return face != "side" && face != "surface";
}

Vector3d plane_normal(const Shape& shape, const std::string& face) {
  if (!is_plane(shape, face)) throw std::invalid_argument("face '" + face + "' is curved");
  const auto [axis, sign] = axis_face(face);
  return sign * Vector3d::Unit(axis);
}

double face_distance(const Shape& shape, const std::string& face, const Vector3d& x) {
  require_face(shape, face);
  if (face == "side") return x.head<2>().norm() - std::get<Cylinder>(shape).radius;
  if (face == "surface") return signed_distance_value(shape, x);
  const auto [axis, sign] = axis_face(face);
  return sign * x[axis] - half_length(shape, axis);
}

bool contains(const Shape& shape, const Vector3d& x, double tolerance) {
  const auto names = face_names(shape);
  return std::all_of(names.begin(), names.end(),
                     [&](const auto& face) { return face_distance(shape, face, x) <= tolerance; });
}

}  // namespace mb
