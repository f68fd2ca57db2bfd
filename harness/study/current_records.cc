#include "harness/study/current_records.h"

#include "harness/study/identity.h"

namespace mb {

namespace {

bool belongs(const Record& record, const std::vector<Scene>& scenes) {
  return std::ranges::any_of(scenes, [&](const Scene& scene) {
    return scene.name == record.case_name && scene.profile == record.profile &&
           run_hash(scene, record.contender) == record.run;
  });
}

bool belongs(const Finding& finding, const std::vector<Scene>& scenes) {
  return std::ranges::any_of(scenes, [&](const Scene& scene) {
    return scene.name == finding.case_name && scene.profile == finding.profile &&
           analysis_hash(scene, finding.analysis) == finding.run;
  });
}

}  // namespace

StoredResults current_records(const Store& store, const std::vector<Scene>& scenes) {
  RecordLines all = store.read_all_records();
  StoredResults results{{}, {}, 0, 0, std::move(all.refused)};
  std::string run;  // marks of one run stand together: its name is made once
  bool current = false;
  for (Record& record : all.records) {
    if (record.run != run) current = belongs(record, scenes);
    run = record.run;
    if (current)
      results.records.push_back(std::move(record));
    else
      ++results.n_other;
  }
  Store::Findings tables = store.read_all_findings();
  std::ranges::move(tables.refused, std::back_inserter(results.refused));
  for (Finding& finding : tables.findings)
    if (belongs(finding, scenes))
      results.findings.push_back(std::move(finding));
    else
      ++results.n_other_tables;
  return results;
}

}  // namespace mb
