// Where and by what the results were made: what records say of it, a row a distinct value.
#pragma once

#include <string>
#include <vector>

#include "reports/views.h"

namespace mb {

// Columns: what, value, records that say so. Dates are one row, first to last; what belongs to a single time (busy,
// repeats) has none. What the records do not say stands as the caller gave it, without a count.
Sheet environment_table(const Evaluation& evaluation);

// The commit that most records name; "" where none does.
struct Commit {
  std::string name;
  long n_records, n_others;  // that name it, that name another
};
Commit main_commit(const Evaluation& evaluation);

// "commit abc" that records and tables name, or "commits abc (2 records) and def (1 record, 3 tables)" where those of
// one kind were made since; "" where none does.
std::string commits_of(const Evaluation& evaluation);

}  // namespace mb
