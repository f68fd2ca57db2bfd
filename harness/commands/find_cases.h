// Where cases are: ./cases, then share/modalbench/cases beside the program.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace mb {

// A name that is no case; what() suggests the nearest.
class UnknownCase : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Files of all cases, sorted by name. Empty where no folder of cases is found.
std::vector<std::filesystem::path> all_cases();

// A file (ends in .toml) as it is, a name by its file. Throws UnknownCase.
std::filesystem::path find_case(const std::string& name_or_file);

}  // namespace mb
