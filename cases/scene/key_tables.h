// The two halves of the table of keys (keys.h).
#pragma once

#include "cases/scene/keys.h"

namespace mb {

const std::vector<KeyGroup>& scene_keys();
const std::vector<KeyGroup>& study_keys();

}  // namespace mb
