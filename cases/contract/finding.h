// A table that an analysis found, beyond the marks of single runs: step limits, aliasing, frequency responses, the
// error budget. The unit of the store for them, one JSON file each.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace mb {

struct FindingColumn {
  std::string name, unit; /* "" for text and for counts */
};
using FindingCell = std::variant<std::string, double>;  // NaN: not applicable or not measured; infinity: unbounded

struct Finding {
  std::string run;       // content hash of scene and analysis
  std::string analysis;  // name of the analysis
  std::string name;      // of this table, unique within the case: "step-limits"
  std::string title;     // "Step limits, formula and measured"
  std::string note;      // what was measured and how, in sentences
  std::string case_name, profile;
  std::vector<FindingColumn> columns;
  std::vector<std::vector<FindingCell>> rows;  // each as long as columns
  std::map<std::string, std::string> provenance;
};

}  // namespace mb
