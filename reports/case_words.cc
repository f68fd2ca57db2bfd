#include "reports/case_words.h"

#include <cmath>

#include "reports/number.h"
#include "reports/words.h"

namespace mb {
namespace {

std::string numbers(const Vector3d& v) {
  constexpr double rounding = 1e-12;  // [-] of the largest component: what turning by a pose leaves
  const double least = rounding * v.cwiseAbs().maxCoeff();
  std::vector<std::string> parts;
  for (const double x : v) parts.push_back(format_setting(std::abs(x) <= least ? 0 : x));
  return "(" + joined(parts, ", ") + ")";
}

struct Words {
  std::string operator()(const Box& box) const {
    return "box of " + format_setting(box.size.x()) + " x " + format_setting(box.size.y()) + " x " +
           in(box.size.z(), "m");
  }
  std::string operator()(const Cylinder& cylinder) const {
    return "cylinder of radius " + in(cylinder.radius, "m") + " and length " + in(cylinder.length, "m");
  }
  std::string operator()(const Sphere& sphere) const { return "sphere of radius " + in(sphere.radius, "m"); }
  std::string operator()(const Superquadric& body) const {
    return "superquadric of semi-axes " + format_setting(body.semi_axes.x()) + ", " +
           format_setting(body.semi_axes.y()) + ", " + in(body.semi_axes.z(), "m") + " and exponents " +
           format_setting(body.e1) + ", " + format_setting(body.e2);
  }
  std::string operator()(const TaperedSuperquadric& body) const {
    return (*this)(body.straight) + ", tapered by " + format_setting(body.taper);
  }
};

}  // namespace

std::string in(double value, const char* unit) { return format_setting(value) + " " + unit; }
std::string in(const Vector3d& value, const char* unit) { return numbers(value) + " " + unit; }

std::string describe(const Shape& shape) { return std::visit(Words{}, shape); }

std::string placed(const Pose& pose) {
  const Eigen::AngleAxisd turn(pose.orientation);
  const double degrees = turn.angle() * 180 / pi;
  const std::string at = "at " + in(pose.position, "m");
  if (turn.angle() < 1e-12) return at;
  return at + ", turned by " + format_number(degrees) + " deg about " + numbers(turn.axis());
}

std::string describe(const RigidSurface& surface) {
  if (const auto* shape = std::get_if<Shape>(&surface.shape)) {
    const std::string edges = surface.rounding > 0 ? "edges rounded by " + in(surface.rounding, "m") : "";
    return joined({describe(*shape), edges, placed(surface.pose)}, ", ");
  }
  return "half-space with normal " + numbers(surface.pose.orientation * Vector3d::UnitZ()) + " through " +
         in(surface.pose.position, "m");
}

}  // namespace mb
