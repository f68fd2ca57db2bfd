// Where cases are: ./cases, then share/modalbench/cases beside the program; hard ones below hard/.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
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
// Each file once, however it was named: by a link, twice.
std::vector<std::filesystem::path> find_cases(const std::vector<std::string>& names_or_files);

// Files by the names that they state.
using NamedFiles = std::vector<std::pair<std::string, std::filesystem::path>>;
// Results are kept by the name of their case: of two files of one name, each would be told what is the other's. Throws
// UsageError, which tells all of them.
void require_names_of_their_own(const NamedFiles& files);

}  // namespace mb
