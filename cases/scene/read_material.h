// [body.material] and [body.damping]: how a body resists and dissipates.
#pragma once

#include "cases/scene/scene.h"
#include "cases/scene/section.h"

namespace mb {

std::optional<Material> read_material(Section section);

struct DampingDraft {
  Rayleigh rayleigh;
  std::vector<double> ratios;
  Position ratios_at;
};
DampingDraft read_damping(Section section);

}  // namespace mb
