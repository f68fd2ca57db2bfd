// What of a scene's runs gained energy that nothing brought, in words: too little to be named unstable
// (harness/study/instability.h), too much to be trusted.
#pragma once

#include <string>
#include <vector>

#include "cases/contract/record.h"
#include "cases/scene/scene.h"

namespace mb {

// One sentence for each run in contact whose energy-gain exceeds a tenth of the energy in play.
std::vector<std::string> energy_warnings(const std::vector<Record>& records, const Scene& scene);

}  // namespace mb
