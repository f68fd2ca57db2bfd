// What went wrong, one row a reason: how many runs it struck and which.
#include <set>
#include <tuple>

#include "reports/views.h"

namespace mb {
namespace {

// "Q1 1x2, newmark, 7 runs from step 0.01 s to step 0.00016 s; eigenmodes, r = 8"
std::string families(const std::vector<Contender>& contenders, Theory theory) {
  std::vector<std::pair<std::string, std::vector<Contender>>> groups;
  for (const Contender& one : contenders) {
    const std::string family = describe_family(one, theory);
    if (groups.empty() || groups.back().first != family) groups.push_back({family, {}});
    groups.back().second.push_back(one);
  }
  std::string text;
  for (const auto& [family, members] : groups) {
    if (!text.empty()) text += "; ";
    text += describe(members.front(), theory);
    if (members.size() == 1) continue;
    text.resize(text.size() - describe_setting(members.front()).size());
    text += std::to_string(members.size()) + " runs from " + describe_setting(members.front()) + " to " +
            describe_setting(members.back());
  }
  return text;
}

}  // namespace

std::vector<Failure> failures_of(const Evaluation& evaluation) {
  const auto before = [](const Contender& a, const Contender& b) { return precedes(a, b); };
  using Contenders = std::set<Contender, decltype(before)>;
  std::map<std::tuple<std::string, std::string, bool, std::string>, std::pair<Contenders, long>> found;
  for (const Record& record : evaluation.input.records) {
    if (is_usable(record)) continue;
    auto& [contenders, n_measures] = found[{record.case_name, record.profile, is_undefined(record), reason(record)}];
    contenders.insert(record.contender);
    ++n_measures;
  }
  std::vector<Failure> all;
  for (const auto& [key, struck] : found) {
    const auto& [case_name, profile, undefined, why] = key;
    const std::vector<Contender> contenders(struck.first.begin(), struck.first.end());
    all.push_back({.case_name = case_name,
                   .profile = profile,
                   .reason = why,
                   .contenders = families(contenders, theory_of(evaluation, case_name, profile)),
                   .n_runs = static_cast<int>(contenders.size()),
                   .n_measures = struck.second,
                   .undefined = undefined});
  }
  return all;
}

Sheet failures_table(const Evaluation& evaluation) {
  Sheet table{.name = "failures",
              .title = "Failures",
              .note = "Measures that have no number, by reason; what is undefined is no fault of the run.",
              .columns = {},
              .rows = {},
              .n_keys = 2};
  table.columns = {
      {"case", ""},   {"profile", ""},   {"runs", "", Column::Kind::number}, {"measures", "", Column::Kind::number},
      {"reason", ""}, {"contenders", ""}};
  for (const Failure& one : failures_of(evaluation)) {
    table.rows.push_back({text_cell(one.case_name), text_cell(one.profile), count_cell(one.n_runs),
                          count_cell(one.n_measures), text_cell(one.reason), text_cell(one.contenders)});
  }
  return table;
}

}  // namespace mb
