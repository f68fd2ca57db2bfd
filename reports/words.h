// Names and counts in sentences.
#pragma once

#include <string>
#include <vector>

namespace mb {

std::string joined(const std::vector<std::string>& parts, const std::string& by);  // empty parts leave no separator
std::string listed(const std::vector<std::string>& names);  // "a, b": six at most, then "and 4 more"
std::string counted(std::size_t n, const std::string& one, const std::string& many);  // "1 run", "2 runs"

}  // namespace mb
