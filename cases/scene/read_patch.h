// `face` and, optionally, `disc = { centre, radius }`: where a support or a traction acts.
#pragma once

#include "cases/scene/read_shape.h"
#include "cases/scene/section.h"
#include "mechanics/geometry/patch.h"
#include "mechanics/geometry/shape.h"

namespace mb {

Words face_words(const Shape& shape);

// Points that a case file states with a few digits may be off by rounding: 1e-9 of the extent, far below any mesh
// error.
double placement_tolerance(const Shape& shape);  // [m]

// Reads both keys of the section, which the caller finishes. Nothing where they are wrong, or where the shape is of no
// known kind, or of no known size and has a disc.
std::optional<Patch> read_patch(Section& section, const ShapeDraft& draft);

}  // namespace mb
