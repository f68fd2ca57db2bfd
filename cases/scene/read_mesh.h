// A mesh of a case file: a resolution, how often it is graded towards where its body touches first, and, of boxes, how
// its cells grow along the axes and how far their corners are moved at random.
#pragma once

#include "cases/scene/read_body.h"

namespace mb {

inline const Range graded_range{0, 12};

// A table with `degree`, `cells`, `graded`, which only bodies with contact take, `bias` and `distorted`, which are of
// boxes that are solids.
std::optional<Resolution> read_mesh(Section section, const BodyDraft& body);

// Records where the body states more damping ratios than it has elastic modes on such a mesh: full order damps them.
void check_ratios(const BodyDraft& body, const Resolution& mesh, const Position& where, Findings& findings);

}  // namespace mb
