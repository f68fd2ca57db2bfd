// Whether a file of the store takes a case's truths, asked before they are computed: what was too large would be
// computed at every run.
#pragma once

#include "cases/scene/scene.h"
#include "harness/store/hdf5.h"

namespace mb {

// Of a truth at one time: 1 + sum over bodies of 3 points + 6 strained points, and 15 of each body in contact (force,
// impulse, two energies, its own energy, momentum). Touches come on top, 7 each.
Index values_at_a_time(const Scene& scene);

// Throws std::runtime_error with both numbers where its samples make more values than `most`.
void require_storable(const Scene& scene, Index most = hdf5_max_elements);

}  // namespace mb
