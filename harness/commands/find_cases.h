// Where cases are: ./cases, then share/modalbench/cases beside the program; hard ones below hard/.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/commands/usage_error.h"

namespace mb {

// A name that is no case; what() suggests the nearest.
class UnknownCase : public UsageError {
 public:
  using UsageError::UsageError;
};

// Files of all cases, sorted by name. Empty where no folder of cases is found.
std::vector<std::filesystem::path> all_cases();

// A file (ends in .toml) as it is, a name by its file. Throws UnknownCase.
std::filesystem::path find_case(const std::string& name_or_file);

}  // namespace mb
