// `shape = { kind, ... }` of bodies and obstacles.
#pragma once

#include <variant>

#include "cases/scene/section.h"
#include "mechanics/contact/rigid_surface.h"
#include "mechanics/geometry/shape.h"

namespace mb {

// As far as it could be read: of which kind it is says what faces and cells it has, whatever its size.
struct ShapeDraft {
  std::optional<Shape> shape;    // nothing where anything in it is wrong
  std::optional<Shape> of_kind;  // the same, or where its sizes are wrong one of its kind; nothing: of no known kind
};

// Superquadrics with exponents in [0.4, 1.4] and tapers up to 0.45 alone: they are meshed.
ShapeDraft read_body_shape(Section section);

// Obstacles may also be half-spaces, which fill z <= 0 of their frame.
std::optional<std::variant<HalfSpace, Shape>> read_obstacle_shape(Section section);

}  // namespace mb
