#include "harness/commands/bytes.h"

#include <fmt/format.h>

namespace mb {

std::string bytes(double n) {
  if (n < 999.5) return fmt::format("{:.0f} B", n);
  constexpr const char* units[] = {"kB", "MB", "GB", "TB"};
  size_t unit = 0;
  n /= 1000;
  for (; n >= 999.5 && unit + 1 < std::size(units); n /= 1000) ++unit;
  const int digits = n < 9.995 ? 2 : n < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f} {}", n, digits, units[unit]);
}

}  // namespace mb
