#include "reports/warnings.h"

#include <algorithm>
#include <iterator>

#include "reports/energy_warnings.h"
#include "reports/linear_warnings.h"

namespace mb {

std::vector<std::string> warnings(const std::vector<Record>& records, const Scene& scene) {
  std::vector<std::string> all = linear_warnings(records, scene);
  std::ranges::move(energy_warnings(records, scene), std::back_inserter(all));
  return all;
}

}  // namespace mb
