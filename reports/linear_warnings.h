// What of a scene lies where linear theory is not to be trusted (cases/contract/linear_limits.h), in words.
#pragma once

#include <string>
#include <vector>

#include "cases/contract/record.h"
#include "cases/scene/scene.h"

namespace mb {

// One sentence for each record of the scene's truth whose strain or rotation is beyond the limit; of bodies of finite
// kinematics it is the contenders that are linear.
std::vector<std::string> linear_warnings(const std::vector<Record>& records, const Scene& scene);

}  // namespace mb
