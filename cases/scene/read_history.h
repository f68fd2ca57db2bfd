// `history = { kind = "pulse", ... }`, tables from a file of two columns included.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/scene/section.h"
#include "mechanics/history/history.h"

namespace mb {

// What the files that a case refers to, and the times at which it ends, depend on.
struct HistoryContext {
  std::filesystem::path folder;            // of the case file: a table's file must lie below it
  std::optional<double> longest_duration;  // [s] of all profiles; nothing: not known
  std::vector<double> looked_at = {};      // [s] when the motion is compared or shown: formulas are finite there
  std::string amplitude_unit = "";         // of s(t): "" for factors on tractions
};

std::optional<History> read_history(Section section, const HistoryContext& context);

}  // namespace mb
