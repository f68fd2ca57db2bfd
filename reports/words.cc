#include "reports/words.h"

#include <algorithm>

namespace mb {

std::string joined(const std::vector<std::string>& parts, const std::string& by) {
  std::string text;
  for (const std::string& part : parts) {
    if (!part.empty()) text += (text.empty() ? "" : by) + part;
  }
  return text;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 6;
  const std::vector<std::string> first(names.begin(), names.begin() + std::min(most, names.size()));
  return joined(first, ", ") + (names.size() > most ? " and " + std::to_string(names.size() - most) + " more" : "");
}

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace mb
