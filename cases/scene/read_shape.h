// `shape = { kind, ... }` of bodies and obstacles.
#pragma once

#include <variant>

#include "cases/scene/section.h"
#include "mechanics/contact/rigid_surface.h"
#include "mechanics/geometry/shape.h"

namespace mb {

// Superquadrics with exponents in [0.4, 1.4] and tapers up to 0.45 alone: they are meshed.
std::optional<Shape> read_body_shape(Section section);

// Obstacles may also be half-spaces, which fill z <= 0 of their frame.
std::optional<std::variant<HalfSpace, Shape>> read_obstacle_shape(Section section);

}  // namespace mb
