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

}  // namespace

ObstacleDraft read_obstacle(Section section) {
  ObstacleDraft obstacle{section.name("name"), std::nullopt, section.where("name")};
  const auto table = section.section("shape");
  const auto shape = table ? read_obstacle_shape(*table) : std::nullopt;
  const auto rounding = read_rounding(section, shape);
  const auto pose = read_pose(section, "pose");
  section.finish();
  if (shape && rounding && pose) obstacle.surface = RigidSurface{*shape, *rounding, *pose};
  return obstacle;
}

}  // namespace mb
