// The known word nearest to a misspelt one, by the number of single-character edits (insertion, deletion, replacement,
// swap of neighbours; Damerau 1964 in its restricted form).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mb {

int n_edits(std::string_view a, std::string_view b);  // compares at most 64 characters of each

// Nothing where even the nearest differs in more than a third of its letters (2 at least): no wild guesses.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& known);

// "did you mean 'x'?", else "known ...: a, b, c"; kind names what is listed: "keys", "faces of a cylinder".
std::string suggestion(std::string_view word, const std::vector<std::string>& known, std::string_view kind);

}  // namespace mb
