#include "reports/environment.h"

#include <algorithm>

#include "reports/times.h"
#include "reports/words.h"

namespace mb {
namespace {

using Counts = std::map<std::string, std::map<std::string, long>>;  // what -> value -> records

// A single time's, not the machine's.
bool is_of_one_time(const std::string& what) { return what == "busy" || what == "repeats"; }

Counts counted_values(const std::vector<Record>& records) {
  Counts counts;
  for (const Record& record : records) {
    for (const auto& [what, value] : record.provenance) {
      if (!is_of_one_time(what)) ++counts[what][value];
    }
  }
  return counts;
}

// ISO 8601: text order is time order.
void merge_dates(Counts& counts) {
  const auto dates = counts.find("date");
  if (dates == counts.end() || dates->second.size() < 2) return;
  const std::string range = dates->second.begin()->first + " to " + dates->second.rbegin()->first;
  long n = 0;
  for (const auto& [date, n_records] : dates->second) n += n_records;
  dates->second = {{range, n}};
}

}  // namespace

Sheet environment_table(const Evaluation& evaluation) {
  Sheet table{.name = "environment",
              .title = "Environment",
              .note = "",
              .columns = {{"what", ""}, {"value", ""}, {"records", "", Column::Kind::number}},
              .rows = {},
              .n_keys = 0};
  Counts counts = counted_values(evaluation.input.records);
  merge_dates(counts);
  for (const auto& [what, value] : evaluation.input.environment) {
    if (!counts.contains(what) && !is_of_one_time(what)) counts[what][value] = 0;
  }
  for (const auto& [what, values] : counts) {
    for (const auto& [value, n] : values) {
      table.rows.push_back({text_cell(what), text_cell(value), n > 0 ? count_cell(n) : text_cell("")});
    }
  }
  const long n_left_out = count_times_left_out(evaluation.input.records);
  if (n_left_out > 0) {
    table.note = counted(n_left_out, "time", "times") +
                 " taken with another processor, BLAS or thread count than most of the case: compared with nothing.";
  }
  return table;
}

Commit main_commit(const Evaluation& evaluation) {
  Counts counts = counted_values(evaluation.input.records);
  const std::map<std::string, long>& commits = counts["commit"];
  if (commits.empty()) {
    const auto given = evaluation.input.environment.find("commit");
    return {given == evaluation.input.environment.end() ? "" : given->second, 0, 0};
  }
  long n_all = 0;
  for (const auto& [commit, n] : commits) n_all += n;
  const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto& [name, n] = *std::max_element(commits.begin(), commits.end(), fewer);
  return {name, n, n_all - n};
}

std::string commits_of(const Evaluation& evaluation) {
  struct Made {
    std::size_t n_records = 0, n_tables = 0;
  };
  std::map<std::string, Made> by;
  for (const Record& record : evaluation.input.records)
    if (record.provenance.contains("commit")) ++by[record.provenance.at("commit")].n_records;
  for (const Finding& finding : evaluation.input.findings)
    if (finding.provenance.contains("commit")) ++by[finding.provenance.at("commit")].n_tables;
  if (by.empty()) {
    const std::string given = main_commit(evaluation).name;
    return given.empty() ? "" : "commit " + given;
  }
  if (by.size() == 1) return "commit " + by.begin()->first;
  std::vector<std::string> all;
  for (const auto& [commit, made] : by)
    all.push_back(commit + " (" +
                  joined({made.n_records > 0 ? counted(made.n_records, "record", "records") : "",
                          made.n_tables > 0 ? counted(made.n_tables, "table", "tables") : ""},
                         ", ") +
                  ")");
  return "commits " + joined(all, " and ");
}

}  // namespace mb
