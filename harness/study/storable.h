// Whether a file of the store takes a case's truths, asked before they are computed: what was too large would be
// computed at every run. The reader of cases asks, too; --set and tests make scenes that it has not seen.
#pragma once

#include "cases/contract/kept.h"
#include "harness/store/hdf5.h"

namespace mb {

static_assert(most_kept_values == hdf5_max_elements, "what the reader of cases lets through is what a file takes");

// Throws std::runtime_error with both numbers where its samples make more values than `most`.
void require_storable(const Scene& scene, Index most = hdf5_max_elements);

}  // namespace mb
