// KEY=VALUE[,VALUE...] from the command line as values of a case file, each of which knows where it was typed: the case
// reader checks them and shows what is wrong there.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cases/scene/toml.h"

namespace mb {

struct Assignments {
  std::string text;  // all of them, one a line: what positions count in
  // By key, an array each; entries are integers, numbers or text, as they read; of the key `cells_key` arrays of them:
  // 1x4 is [1, 4].
  std::vector<TomlEntry> values;
  const TomlValue* find(std::string_view key) const;  // nullptr where it is not set
};

// Throws CaseErrors with every key that is not known (and the nearest that is), given twice or without a value.
Assignments read_assignments(const std::vector<std::string>& given, const std::vector<std::string>& known_keys,
                             const std::string& cells_key);

}  // namespace mb
