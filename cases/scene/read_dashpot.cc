#include "cases/scene/read_dashpot.h"

#include "cases/scene/read_direction.h"
#include "cases/scene/read_patch.h"

namespace mb {

DashpotDrafts read_dashpots(Section& body, const ShapeDraft& shape) {
  DashpotDrafts drafts;
  for (Section& section : body.sections("dashpot", {0, 64})) {
    drafts.at.push_back(section.where());
    const auto patch = read_patch(section, shape);
    const auto direction = read_direction(section, "direction");
    const auto damping = section.number("damping", {1e-12, 1e15, "N s/m"});
    section.finish();
    if (patch && direction && damping) drafts.dashpots.push_back({*patch, *direction, *damping});
  }
  return drafts;
}

}  // namespace mb
