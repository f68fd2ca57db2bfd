#include "cases/scene/read_shape.h"

#include <fmt/format.h>

#include <cmath>

#include "mechanics/geometry/tapered.h"

namespace mb {

namespace {

const Range length_range{1e-6, 1e4, "m"};  // from a grain to a mountain

std::optional<std::string> read_kind(Section& section, std::vector<std::string> known) {
  const auto kind = section.choice("kind", {std::move(known), "shape kind", "shape kinds"});
  if (!kind) section.finish(false);
  return kind;
}

// Of superquadrics.
struct Allowed {
  Range exponents, taper;
};
const Allowed rigid{{0.1, 2}, {-1, 1}};           // nearly a box to an octahedron: convex throughout
const Allowed meshed{{0.4, 1.4}, {-0.45, 0.45}};  // beyond, cells are flatter than those of coarse balls

// Contact is found of convex shapes (tapered.h).
bool is_convex(Section& section, double e1, double taper) {
  const double most = largest_taper(e1);
  if (std::abs(taper) <= most) return true;
  section.error("taper", fmt::format("'taper' is {}: with exponent e1 = {} a body is convex up to {:.3f}", taper, e1,
                                     std::floor(1e3 * most) / 1e3));
  return false;
}

std::optional<Shape> read_superquadric(Section& section, const Allowed& allowed) {
  const auto semi_axes = section.vector("semi_axes", length_range);
  const auto exponents = section.numbers("exponents", allowed.exponents, {2, 2});
  const double taper = section.number("taper", allowed.taper, 0);
  if (!semi_axes || !exponents) return std::nullopt;
  const Superquadric straight{*semi_axes, (*exponents)[0], (*exponents)[1]};
  if (taper == 0) return straight;
  if (!is_convex(section, straight.e1, taper)) return std::nullopt;
  return TaperedSuperquadric{straight, taper};
}

std::optional<Shape> read_sized(Section& section, const std::string& kind, const Allowed& allowed) {
  if (kind == "superquadric") return read_superquadric(section, allowed);
  if (kind == "box") {
    const auto size = section.vector("size", length_range);
    return size ? std::optional<Shape>(Box{*size}) : std::nullopt;
  }
  const auto radius = section.number("radius", length_range);
  if (kind == "sphere") return radius ? std::optional<Shape>(Sphere{*radius}) : std::nullopt;
  const auto length = section.number("length", length_range);
  return radius && length ? std::optional<Shape>(Cylinder{*radius, *length}) : std::nullopt;
}

Shape unit_shape(const std::string& kind) {
  if (kind == "box") return Box{Vector3d::Ones()};
  if (kind == "cylinder") return Cylinder{1, 1};
  if (kind == "sphere") return Sphere{1};
  return Superquadric{Vector3d::Ones(), 1, 1};
}

}  // namespace

ShapeDraft read_body_shape(Section section) {
  const auto kind = read_kind(section, {"box", "cylinder", "sphere", "superquadric"});
  if (!kind) return {};
  const auto shape = read_sized(section, *kind, meshed);
  section.finish();
  return {shape, shape ? *shape : unit_shape(*kind)};
}

std::optional<std::variant<HalfSpace, Shape>> read_obstacle_shape(Section section) {
  const auto kind = read_kind(section, {"half-space", "box", "cylinder", "sphere", "superquadric"});
  if (!kind) return std::nullopt;
  const bool is_half_space = *kind == "half-space";
  const auto shape = is_half_space ? std::nullopt : read_sized(section, *kind, rigid);
  section.finish();
  if (is_half_space) return HalfSpace{};
  if (!shape) return std::nullopt;
  return *shape;
}

}  // namespace mb
