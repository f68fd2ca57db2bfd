// A run is one contender on one case: the records that grade it, brought together.
//
//   records (one number each)  ->  runs (one contender each: what it answered, what it cost)
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cases/contract/record.h"

namespace mb {

struct Measure {
  std::string metric, subject, truth;
  auto operator<=>(const Measure&) const = default;
};

struct Run {
  std::string case_name, profile;
  Contender contender;
  int modes_used = -1;                    // elastic modes; -1: full order
  long n_unknowns = 0;                    // degrees of freedom stepped in time
  std::map<Measure, Record> measures;     // all but the times
  std::optional<Record> online, offline;  // [s]
};

// One entry a contender, a case and a profile; a later record of the same measure replaces an earlier one. Sorted by
// case, profile, reduced before full order, method, integrator, modes, mesh and time step (largest first).
std::vector<Run> group_runs(const std::vector<Record>& records);

bool same_contender(const Contender& a, const Contender& b);
bool is_reduced(const Contender& contender);
bool is_mark(const Record& record);                      // measured against a truth, unlike times and load errors
bool is_usable(const Record& record);                     // status ok and a finite value
double counted_error(const Record& record);               // |value|, or the error bar where that is larger
std::string describe(const Contender& contender);         // "eigenmodes, r = 8", "Q2 1x4, newmark, step 1.25e-3 s"
std::string describe_series(const Contender& contender);  // as drawn: "eigenmodes", "full order Q2, newmark"

}  // namespace mb
