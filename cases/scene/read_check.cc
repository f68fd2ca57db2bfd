#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/read_study.h"

namespace mb {

namespace {

// A limit beyond a million body sizes, or below what double precision resolves, checks nothing.
const Range limit_range{0, 1e6};

void read_limit(Section& section, Check& check) {
  const bool has_most = section.has("at_most");
  const bool has_least = section.has("at_least");
  if (has_most && has_least) {
    section.error("at_least",
                  fmt::format("{} has both 'at_most' and 'at_least': exactly one of them", section.title()));
  } else if (has_most) {
    check.at_most = section.number("at_most", limit_range);
  } else if (has_least) {
    check.at_least = section.number("at_least", limit_range);
  } else {
    section.missing("at_most", "or 'at_least', a number in " + to_string(limit_range));
  }
}

// Modes and method must be among what the study runs, else the check would never be answered.
void check_is_run(Section& section, const Check& check, const Study& study) {
  if (!study.modes.empty() && std::find(study.modes.begin(), study.modes.end(), check.modes) == study.modes.end()) {
    section.error("modes", fmt::format("the study does not run {} modes", check.modes),
                  "'modes' of a check is one of the mode counts in [study]");
  }
  if (!study.methods.empty() &&
      std::find(study.methods.begin(), study.methods.end(), check.method) == study.methods.end()) {
    section.error("method", fmt::format("the study does not run method '{}'", check.method),
                  "'method' of a check is one of the methods in [study]");
  }
}

}  // namespace

std::optional<Check> read_check(Section section, const std::optional<Study>& study, const Vocabulary& vocabulary) {
  const auto method = section.choice("method", {vocabulary.methods, "method", "methods"});
  const auto metric = section.choice("metric", {vocabulary.metrics, "metric", "metrics"});
  const auto truth = section.choice("truth", {{"finer", "same_mesh"}, "truth", "truths"});
  const auto modes = section.integer("modes", {0, 4096});
  const auto why = section.text("why", 1000);
  Check check{};
  read_limit(section, check);
  section.finish();
  if (!method || !metric || !truth || !modes || !why) return std::nullopt;
  check.method = *method;
  check.metric = *metric;
  check.truth = *truth;
  check.modes = *modes;
  check.why = *why;
  if (study) check_is_run(section, check, *study);
  return check;
}

}  // namespace mb
