#include "reports/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/contract/status.h"

namespace mb {
namespace {

int decade(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

}  // namespace

std::string format_number(double value, int digits) {
  if (!std::isfinite(value)) return "not finite";
  if (value == 0) return "0";
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);  // rounds first: 0.9999 is of decade 0
  const auto e = scientific.find('e');
  const int exponent = std::stoi(scientific.substr(e + 1));
  if (exponent < -3 || exponent >= 5) return fmt::format("{}e{}", scientific.substr(0, e), exponent);
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent));
}

std::string format_range(double low, double high) {
  if (std::isnan(low) || std::isnan(high)) return "single run";
  return format_number(low) + " to " + (std::isfinite(high) ? format_number(high) : "unbounded");
}

std::string percent(double fraction) { return format_number(100 * fraction, 1) + " %"; }

std::string format_setting(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : "not finite"; }

std::string exact_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

std::string format_with_bar(double value, std::optional<double> bar) {
  if (!bar || !(*bar > 0)) return format_number(value);
  if (std::isinf(*bar)) return format_number(value) + " \u00b1 unknown";
  if (std::abs(value) < *bar) return "<= " + format_number(std::abs(value) + *bar, 2);
  return format_number(value, std::clamp(decade(value) - decade(*bar) + 1, 1, 3));
}

std::string format_record(const Record& record) {
  if (is_undefined(record.status)) return "undefined";
  if (record.status.starts_with("failed")) return "failed";
  if (record.status != "ok") return "failed (" + record.status + ")";
  if (!std::isfinite(record.value)) return "failed (not finite)";
  return format_with_bar(record.value, record.error_bar);
}

}  // namespace mb
