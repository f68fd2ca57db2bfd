// Records of a store that belong to scenes as they are now, by this build: those whose name is the content hash of the
// scene and their own contender. Contenders which the case no longer lists, or --set added, count as well.
#pragma once

#include <vector>

#include "harness/store/store.h"

namespace mb {

struct StoredResults {
  std::vector<Record> records;
  std::vector<Finding> findings;
  size_t n_other = 0;                // records of other scenes or builds: left out
  std::vector<RefusedLine> refused;  // damaged lines and files
};
StoredResults current_records(const Store& store, const std::vector<Scene>& scenes);

}  // namespace mb
