// The highest point of a smooth curve within a bracket that holds one peak, by golden section: Kiefer 1953, Proc. Am.
// Math. Soc. 4(3).
#pragma once

#include <functional>

namespace mb {

struct Peak {
  double at, height;
};

// Of y on [first, last], 0 < first < last, to `tolerance` [-] relative to x, in about 2 ln((last - first) / (tolerance
// x)) evaluations. Where y has no peak inside, an end of the bracket. Throws std::invalid_argument.
Peak highest(const std::function<double(double)>& y, double first, double last, double tolerance = 1e-4);

}  // namespace mb
