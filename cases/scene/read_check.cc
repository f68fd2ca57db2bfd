#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/read_study.h"

namespace mb {

namespace {

constexpr std::size_t most_label = 200;  // [bytes] of a column's name or a row's first cell

// Marks are relative errors or times: beyond a million, or below what double precision resolves, a limit checks
// nothing.
const Range mark_range{0, 1e6};
const Range cell_range{-1e15, 1e15};  // of tables: any unit

void read_limit(Section& section, const Range& range, Check& check) {
  const bool has_most = section.has("at_most");
  const bool has_least = section.has("at_least");
  if (has_most && has_least) {
    section.error("at_least",
                  fmt::format("{} has both 'at_most' and 'at_least': exactly one of them", section.title()));
  } else if (has_most) {
    check.at_most = section.number("at_most", range);
  } else if (has_least) {
    check.at_least = section.number("at_least", range);
  } else {
    section.missing("at_most", "or 'at_least', a number in " + to_string(range));
  }
}

// Modes and method must be among what the study runs in every profile, else the check would never be answered.
void check_is_run(Section& section, const Check& check, const CheckContext& context, bool has_modes) {
  const Study& study = *context.study;
  if (has_modes && !study.modes.empty() &&
      std::find(study.modes.begin(), study.modes.end(), check.modes) == study.modes.end()) {
    section.error("modes", fmt::format("{} does not run {} modes", context.runs, check.modes),
                  "'modes' of a check is one of the mode counts in [study], and in every profile that states others");
  }
  const auto is_asked = [&](RotationCoupling rotation) { return to_string(rotation) == check.rotation; };
  if (!check.rotation.empty() && std::ranges::none_of(study.rotations, is_asked))
    section.error("rotation", fmt::format("the study does not run rotation '{}'", check.rotation),
                  "'rotation' of a check is one of those in [study]");
  if (!study.methods.empty() &&
      std::find(study.methods.begin(), study.methods.end(), check.method) == study.methods.end()) {
    section.error("method", fmt::format("the study does not run method '{}'", check.method),
                  "'method' of a check is one of the methods in [study]");
  }
}

std::optional<int> no_modes(Section& section, const std::optional<std::string>& method) {
  if (section.has("modes") && method) {
    section.findings().error(section.where_key("modes"), fmt::format("method '{}' takes no mode count", *method),
                             "leave 'modes' out");
  }
  return 0;
}

// Of a run: method, metric, truth and, where the method takes one, the mode count.
bool read_run(Section& section, const CheckContext& context, const Vocabulary& vocabulary, Check& check) {
  const auto method = section.choice("method", {vocabulary.methods, "method", "methods"});
  const auto metric = section.choice("metric", {vocabulary.metrics, "metric", "metrics"});
  const auto truth = section.choice("truth", {{"finer", "same_mesh", "exact"}, "truth", "truths"});
  if (truth == "exact" && !context.has_exact) {
    section.error("truth", "there is no exact truth: [truth] has no key 'exact', which names a closed form");
  }
  const bool has_modes = method ? takes_modes(*method, vocabulary) : section.has("modes");
  const auto modes = has_modes ? section.integer("modes", {0, 4096}) : no_modes(section, method);
  if (section.has("rotation"))
    check.rotation =
        section.choice("rotation", {{"rigid", "coupled", "unstiffened"}, "rotation", "rotations"}).value_or("");
  if (!method || !metric || !truth || !modes) return false;
  check.method = *method;
  check.metric = *metric;
  check.truth = *truth;
  check.modes = *modes;
  if (context.study) check_is_run(section, check, context, has_modes);
  return true;
}

// Of a table that an analysis makes: every row of a column, or those that begin with `row`.
bool read_table_check(Section& section, const CheckContext& context, Check& check) {
  for (const char* key : {"method", "metric", "truth", "modes", "rotation"}) {
    if (!section.has(key)) continue;
    section.findings().error(
        section.where_key(key),
        fmt::format("{} has both 'table' and '{}': a check is of a table or of a run", section.title(), key),
        "of a table: table, column, row; of a run: method, metric, truth, modes, rotation");
  }
  const auto table = section.name("table");
  const auto column = section.text("column", most_label);
  check.row = section.text("row", most_label, "");
  if (table && context.study && context.study->analyses.empty()) {
    section.error("table", "no analysis makes tables: [study] has no key 'analyses'");
  }
  if (!table || !column) return false;
  check.table = *table;
  check.column = *column;
  return true;
}

}  // namespace

std::optional<Check> read_check(Section section, const CheckContext& context, const Vocabulary& vocabulary) {
  Check check{};
  bool of_table = false;
  for (const char* key : {"table", "column", "row"}) of_table = section.has(key) || of_table;
  bool whole = of_table ? read_table_check(section, context, check) : read_run(section, context, vocabulary, check);
  const auto why = section.prose("why", 1000);
  read_limit(section, of_table ? cell_range : mark_range, check);
  section.finish();
  if (!whole || !why) return std::nullopt;
  check.why = *why;
  return check;
}

}  // namespace mb
