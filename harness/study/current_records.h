// Records of a store that belong to scenes as they are now, by this build.
#pragma once

#include <vector>

#include "harness/store/store.h"

namespace mb {

struct StoredResults {
  std::vector<Record> records;
  size_t n_other = 0;                // records of other settings, scenes or builds: left out
  std::vector<RefusedLine> refused;  // damaged lines
};
StoredResults current_records(const Store& store, const std::vector<Scene>& scenes);

}  // namespace mb
