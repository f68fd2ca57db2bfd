#include "harness/study/current_records.h"

#include <set>

#include "harness/study/identity.h"
#include "harness/study/plan.h"

namespace mb {

StoredResults current_records(const Store& store, const std::vector<Scene>& scenes) {
  std::set<std::string> wanted;
  for (const Scene& scene : scenes) {
    for (const Contender& contender : contenders(scene)) wanted.insert(run_hash(scene, contender));
    for (const Contender& truth : truth_contenders(scene)) wanted.insert(run_hash(scene, truth));
  }
  RecordLines all = store.read_all_records();
  StoredResults results{{}, 0, std::move(all.refused)};
  for (Record& record : all.records) {
    if (wanted.contains(record.run))
      results.records.push_back(std::move(record));
    else
      ++results.n_other;
  }
  return results;
}

}  // namespace mb
