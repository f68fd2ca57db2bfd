// Where a number comes from: commit, date, machine, threads, libraries.
#pragma once

#include <map>
#include <string>

namespace mb {

std::map<std::string, std::string> provenance(const std::string& profile);

}  // namespace mb
