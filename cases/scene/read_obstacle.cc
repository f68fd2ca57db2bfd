#include "cases/scene/read_obstacle.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/read_pose.h"
#include "cases/scene/read_shape.h"

namespace mb {

namespace {

using Surface = std::variant<HalfSpace, Shape>;

// [m] of shapes that have edges or rims to be rounded; 0 of others.
double smallest_extent(const Surface& surface) {
  const auto* shape = std::get_if<Shape>(&surface);
  if (shape == nullptr) return 0;
  if (const auto* box = std::get_if<Box>(shape)) return box->size.minCoeff();
  const auto* cylinder = std::get_if<Cylinder>(shape);
  return cylinder == nullptr ? 0 : std::min(2 * cylinder->radius, cylinder->length);
}

// 0 where absent; nothing where it is wrong, or where the shape is, which bounds it.
std::optional<double> read_rounding(Section& section, const std::optional<Surface>& surface) {
  if (!section.has("rounding")) return 0;
  if (!surface) return std::nullopt;
  const double smallest = smallest_extent(*surface);
  if (smallest > 0) return section.number("rounding", {0, smallest / 2, "m", true, true});
  section.findings().error(section.where_key("rounding"),
                           "'rounding' is of no use: only a box and a cylinder have edges", "leave 'rounding' out");
  return std::nullopt;
}

constexpr const char* striking[] = {"mass", "velocity", "youngs_modulus", "poissons_ratio"};

// Where it strikes is not for the obstacle to say, and how is along z.
void check_way(Section& section, const std::optional<Vector3d>& velocity) {
  if (section.has("pose"))
    section.findings().error(section.where_key("pose"),
                             "an obstacle that strikes touches the middle of the body's top face at t = 0",
                             "leave 'pose' out");
  if (velocity && !(velocity->x() == 0 && velocity->y() == 0 && velocity->z() < 0))
    section.error("velocity", "'velocity' of an obstacle that strikes must be [0, 0, -v], v > 0: it comes down");
}

// Of one that states any of these keys; nothing where something is wrong with them.
std::optional<Striker> read_striker(Section& section, const std::optional<Surface>& surface) {
  const auto mass = section.number("mass", {1e-12, 1e12, "kg"});
  const auto velocity = section.vector("velocity", {-1e4, 1e4, "m/s"});
  const auto modulus = section.number("youngs_modulus", {1, 1e13, "Pa"});
  const auto ratio = section.number("poissons_ratio", {-1, 0.5, "", true, true});
  check_way(section, velocity);
  const auto* shape = surface ? std::get_if<Shape>(&*surface) : nullptr;
  if (surface && !(shape && std::holds_alternative<Sphere>(*shape)))
    section.error("shape", "an obstacle that strikes is a sphere: Hertz's law is that of one");
  if (!mass || !velocity || !modulus || !ratio) return std::nullopt;
  return Striker{*mass, -velocity->z(), *modulus, *ratio};
}

}  // namespace

ObstacleDraft read_obstacle(Section section) {
  ObstacleDraft obstacle{section.name("name"), std::nullopt, section.where("name")};
  const auto table = section.section("shape");
  const auto shape = table ? read_obstacle_shape(*table) : std::nullopt;
  const auto rounding = read_rounding(section, shape);
  const auto pose = read_pose(section, "pose");
  for (const char* key : striking) obstacle.strikes = section.has(key) || obstacle.strikes;
  if (obstacle.strikes) obstacle.striker = read_striker(section, shape);
  section.finish();
  if (shape && rounding && pose) obstacle.surface = RigidSurface{*shape, *rounding, *pose};
  return obstacle;
}

}  // namespace mb
