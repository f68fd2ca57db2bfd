#include "reports/check_cells.h"

#include <cmath>

#include "reports/number.h"

namespace mb {

// With all digits: 1.000000001 is not 1.
std::string bound(const Check& check) {
  if (!check.status.empty()) return check.status;
  if (check.at_most) return "<= " + exact_number(*check.at_most);
  return check.at_least ? ">= " + exact_number(*check.at_least) : "no bound";
}

// Close to its bound a value has the digits that tell it from it: 1.000000 rather than 1.00 against 0.999.
Cell measured_cell(const CheckResult& result) {
  if (!result.measured) return text_cell("none");
  if (!result.check.status.empty()) return text_cell(result.status);
  const bool is_count = result.unit.empty() && !result.check.table.empty() && result.value == std::floor(result.value);
  if (is_count && std::abs(result.value) < 1e9) return count_cell(std::lround(result.value));
  const double bound = result.check.at_most ? *result.check.at_most : result.check.at_least.value_or(0);
  const bool is_close = std::abs(result.value - bound) <= 0.01 * std::abs(bound);
  return {.text = is_close ? format_number(result.value, 7) : format_with_bar(result.value, result.error_bar),
          .value = result.value};
}

Cell bar_cell(const CheckResult& result) {
  if (!result.measured || !(result.error_bar > 0)) return text_cell("");
  if (std::isinf(result.error_bar)) return text_cell("unknown");
  return {.text = format_number(result.error_bar, 2), .value = result.error_bar};
}

std::string verdict(const CheckResult& result) {
  if (!result.measured) return result.status == "no record" ? "not measured" : "failed (" + result.status + ")";
  if (!result.decidable) return "not decidable: the bound is within the error bar";
  return result.holds ? "holds" : "does not hold";
}

}  // namespace mb
