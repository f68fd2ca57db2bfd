// Records of a store that belong to scenes as they are now, by this build: those whose name is the content hash of the
// scene and their own contender. Contenders which the case no longer lists, or --set added, count as well. Tables are
// of the whole study, which a table does not repeat: those made under --set are no longer known for what they are.
#pragma once

#include <vector>

#include "harness/store/store.h"

namespace mb {

struct StoredResults {
  std::vector<Record> records;
  std::vector<Finding> findings;
  size_t n_other = 0;                // records of other scenes or builds: left out
  size_t n_other_tables = 0;         // likewise, and of other studies of these scenes (--set)
  std::vector<RefusedLine> refused;  // damaged lines and files
};
StoredResults current_records(const Store& store, const std::vector<Scene>& scenes);

}  // namespace mb
