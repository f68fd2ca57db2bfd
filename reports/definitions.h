// What the words of a report mean.
#pragma once

#include <string>
#include <vector>

#include "reports/views.h"

namespace mb {

struct Explanation {
  std::string term, text;
};
// Metrics as they were given, where they are measured, then the report's own words.
std::vector<Explanation> definitions(const Evaluation& evaluation);

}  // namespace mb
