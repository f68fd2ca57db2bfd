// A mesh of a case file: a resolution, and how often it is graded towards where its body touches first.
#pragma once

#include "cases/scene/read_body.h"

namespace mb {

inline const Range graded_range{0, 12};

// A table with `degree`, `cells` and `graded`, the last of which only bodies with contact take.
std::optional<Resolution> read_mesh(Section section, const BodyDraft& body);

}  // namespace mb
