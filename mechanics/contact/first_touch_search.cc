#include "mechanics/contact/first_touch_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace mb {

void require_valid(const TouchSearch& s) {
  if (!(std::isfinite(s.t0) && std::isfinite(s.t1) && s.t0 <= s.t1))
    throw std::invalid_argument(fmt::format("first_touch: from t0 = {} s to t1 = {} s is no interval", s.t0, s.t1));
  if (!(s.tolerance > 0 && std::isfinite(s.tolerance)))
    throw std::invalid_argument(fmt::format("first_touch: the tolerance is {} m, not finite and > 0", s.tolerance));
  if (!(s.depth >= 0 && std::isfinite(s.depth)))
    throw std::invalid_argument(fmt::format("first_touch: the depth is {} m, not finite and >= 0", s.depth));
  if (s.budget <= 0)
    throw std::invalid_argument(fmt::format("first_touch: the budget is {} evaluations, not > 0", s.budget));
}

double touch_tolerance(const TouchSearch& search, double coordinates) {
  return std::max(search.tolerance, 512 * std::numeric_limits<double>::epsilon() * coordinates);
}

}  // namespace mb
