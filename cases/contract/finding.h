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

// What a table is held to.
struct Footing {
  std::string reference;    // "the truth of the case", "peaks published by NAFEMS, 1989"
  std::string kind;         // converged numbers, closed form, published, second route, property; "measurement" where
                            // it is held to nothing
  std::string uncertainty;  // of the numbers, where no bar stands beside them
};

struct Finding {
  std::string run;       // content hash of scene and analysis
  std::string analysis;  // name of the analysis
  std::string name;      // of this table, unique within the case: "step-limits"
  std::string title;     // "Step limits, formula and measured"
  std::string note;      // what was measured and how, in sentences
  std::string case_name, profile;
  std::vector<FindingColumn> columns;
  std::vector<std::vector<FindingCell>> rows;  // each as long as columns
  std::vector<std::vector<double>> bars = {};  // error bar of each cell, in its unit, NaN where it has none; or empty
  Footing footing = {};
  std::map<std::string, std::string> provenance;
};

}  // namespace mb
