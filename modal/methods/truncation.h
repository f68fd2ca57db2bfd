// What the methods on eigenmodes share: every body of the model in its lowest modes.
#pragma once

#include "cases/contract/linear.h"

namespace mb {

// settings.modes elastic modes of each body, rounded up to whole multiplets. corrected: add the static response of the
// modes left out. Throws std::invalid_argument for settings.modes < 0.
Reduction in_eigenmodes(const Model& model, const Settings& settings, bool corrected);

}  // namespace mb
