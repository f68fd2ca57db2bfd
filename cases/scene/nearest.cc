#include "cases/scene/nearest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "cases/scene/printable.h"

namespace mb {

namespace {
constexpr std::size_t longest = 64;
}

int n_edits(std::string_view a, std::string_view b) {
  a = a.substr(0, longest);
  b = b.substr(0, longest);
  std::array<std::array<int, longest + 1>, longest + 1> d{};
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& known) {
  std::optional<std::string> best;
  int fewest = 0;
  for (const std::string& candidate : known) {
    const int edits = n_edits(word, candidate);
    if (edits > std::max<int>(2, static_cast<int>(candidate.size()) / 3)) continue;
    if (edits >= static_cast<int>(candidate.size())) continue;  // nothing in common
    if (!best || edits < fewest) {
      best = candidate;
      fewest = edits;
    }
  }
  return best;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known, std::string_view kind) {
  if (const auto candidate = nearest(word, known)) return fmt::format("did you mean '{}'?", printable(*candidate));
  if (known.empty()) return fmt::format("there are no {}", kind);
  std::vector<std::string> shown;  // names of files may be anything
  for (const std::string& word_known : known) shown.push_back(printable(word_known));
  return fmt::format("{}: {}", kind, fmt::join(shown, ", "));
}

}  // namespace mb
