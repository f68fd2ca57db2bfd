#include "cases/scene/read_shape.h"

namespace mb {

namespace {

const Range length_range{1e-6, 1e4, "m"};  // from a grain to a mountain
const Range exponent_range{0.1, 2};        // nearly a box to an octahedron: convex throughout

std::optional<std::string> read_kind(Section& section, std::vector<std::string> known) {
  const auto kind = section.choice("kind", {std::move(known), "shape kind", "shape kinds"});
  if (!kind) section.finish(false);
  return kind;
}

std::optional<Shape> read_superquadric(Section& section) {
  const auto semi_axes = section.vector("semi_axes", length_range);
  const auto exponents = section.numbers("exponents", exponent_range, {2, 2});
  if (!semi_axes || !exponents) return std::nullopt;
  return Superquadric{*semi_axes, (*exponents)[0], (*exponents)[1]};
}

std::optional<Shape> read_sized(Section& section, const std::string& kind) {
  if (kind == "superquadric") return read_superquadric(section);
  if (kind == "box") {
    const auto size = section.vector("size", length_range);
    return size ? std::optional<Shape>(Box{*size}) : std::nullopt;
  }
  const auto radius = section.number("radius", length_range);
  if (kind == "sphere") return radius ? std::optional<Shape>(Sphere{*radius}) : std::nullopt;
  const auto length = section.number("length", length_range);
  return radius && length ? std::optional<Shape>(Cylinder{*radius, *length}) : std::nullopt;
}

}  // namespace

std::optional<Shape> read_body_shape(Section section) {
  const auto kind = read_kind(section, {"box", "cylinder", "sphere", "superquadric"});
  if (!kind) return std::nullopt;
  if (*kind == "superquadric") {
    section.error("kind", "shape kind 'superquadric' is understood, but cannot be simulated yet");
    return std::nullopt;
  }
  auto shape = read_sized(section, *kind);
  section.finish();
  return shape;
}

std::optional<std::variant<HalfSpace, Shape>> read_obstacle_shape(Section section) {
  const auto kind = read_kind(section, {"half-space", "box", "cylinder", "sphere", "superquadric"});
  if (!kind) return std::nullopt;
  const bool is_half_space = *kind == "half-space";
  const auto shape = is_half_space ? std::nullopt : read_sized(section, *kind);
  section.finish();
  if (is_half_space) return HalfSpace{};
  if (!shape) return std::nullopt;
  return *shape;
}

}  // namespace mb
