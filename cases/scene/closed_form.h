// What a case asks of the closed forms (cases/exact/): their names, and whether one holds for a scene.
#pragma once

#include <string>
#include <vector>

#include "cases/scene/scene.h"

namespace mb {

std::vector<std::string> closed_form_names();
// Empty where scene.truth.exact holds for the scene or names none; else one sentence that says why not.
std::string closed_form_problem(const Scene& scene);

}  // namespace mb
