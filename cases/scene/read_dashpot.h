// [[body.dashpot]]: dampers between a body and the ground.
#pragma once

#include "cases/scene/read_shape.h"
#include "cases/scene/scene.h"
#include "cases/scene/section.h"

namespace mb {

struct DashpotDrafts {
  std::vector<Dashpot> dashpots; /* those without a problem */
  std::vector<Position> at;      /* of all of them, right or wrong */
};

DashpotDrafts read_dashpots(Section& body, const ShapeDraft& shape);

}  // namespace mb
