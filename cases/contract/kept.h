// How much of a truth a file of the store keeps, known before it is computed.
#pragma once

#include <string>

#include "cases/scene/scene.h"

namespace mb {

inline constexpr Index most_kept_values = Index{1} << 26;  // [-] 512 MiB

// Of a truth at one time: 1 + sum over bodies of 3 points + 6 strained points, and 15 of each body in contact (force,
// impulse, two energies, its own energy, momentum). Touches come on top, 7 each.
Index values_at_a_time(const Scene& scene);

// Both numbers where the scene's samples make more values than `most`; empty where they do not.
std::string kept_problem(const Scene& scene, Index most = most_kept_values);

}  // namespace mb
