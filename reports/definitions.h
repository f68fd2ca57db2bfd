// What the words of a report mean.
#pragma once

#include <string>
#include <vector>

#include "reports/views.h"

namespace mb {

struct Explanation {
  std::string term, text;
};
std::vector<Explanation> own_words();  // of this folder alone: metrics and times are defined where they are measured

// Metrics as they were given, then the report's own words.
std::vector<Explanation> definitions(const Evaluation& evaluation);

}  // namespace mb
