// What the results of a scene are to be read with, a sentence each: linear theory where it is not to be trusted, steps
// in contact that gain energy, steps of which nobody knows whether they are past their limit.
#pragma once

#include <string>
#include <vector>

#include "cases/contract/record.h"
#include "cases/scene/scene.h"

namespace mb {

// Of the scene's own records among those given.
std::vector<std::string> warnings(const std::vector<Record>& records, const Scene& scene);

}  // namespace mb
