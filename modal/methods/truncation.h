// What the methods of this folder share: every body of the model reduced, one stepper for each.
#pragma once

#include <memory>

#include "cases/contract/method.h"

namespace mb {

// corrected: add the static response of the modes left out. Throws std::invalid_argument for settings.modes < 0.
std::unique_ptr<Prepared> prepare_truncated(const Model& model, const Settings& settings, const Integrator& integrator,
                                            bool corrected);

}  // namespace mb
