// Formulas from case files: whatever the text, it is refused by a std::domain_error or has the value that it has in
// parentheses, each time again; its bounds over intervals hold each value; and what expression_problem lets pass is
// finite at every time asked for, and elsewhere finite or, within a few ulp, said to be not.
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "mechanics/history/enclosure.h"
#include "mechanics/history/expression.h"
#include "mechanics/history/history.h"

namespace {

using Bits = std::optional<std::uint64_t>;  // to the last bit; nothing where the value is refused

Bits value(const mb::Formula& formula, double t) {
  try {
    return std::bit_cast<std::uint64_t>(formula(t));
  } catch (const std::domain_error&) {
    return {};
  }
}

void require_same_values(const std::string& text) {
  const mb::Formula formula(text), enclosed("(" + text + ")");
  for (const double t : {0.0, 0.3, 1.0, 1e6}) {
    const Bits first = value(formula, t);
    if (value(formula, t) != first) throw std::logic_error("another value the second time");
    if (value(enclosed, t) != first) throw std::logic_error("another value in parentheses");
  }
}

// Between the points that were looked at it may not be finite, and then says that and where, nothing else.
void require_value_or_its_name(const mb::Formula& formula, double t) {
  try {
    formula(t);
  } catch (const std::domain_error& error) {
    if (std::string(error.what()).find("is not finite at t = ") == std::string::npos)
      throw std::logic_error("refused between the points that were looked at");
  }
}

// Two readers of one grammar, muParser's values and our bounds.
void require_bounds(const std::string& text) {
  const mb::Formula formula(text);
  const mb::Enclosure bounds = mb::enclosure(text);
  for (const double width : {0.0, 1e-9, 0.01, 1.0}) {
    for (const double start : {0.0, 0.3, 0.75}) {
      const mb::Interval s = bounds({start, start + width});
      for (const double t : {start, start + 0.4 * width, start + width}) {
        const Bits value_at_t = value(formula, t);
        if (!value_at_t && s.defined && std::isfinite(s.lo) && std::isfinite(s.hi))
          throw std::logic_error("bounds where there is no value");
        const double x = value_at_t ? std::bit_cast<double>(*value_at_t) : s.lo;
        if (!(s.lo <= x && x <= s.hi)) throw std::logic_error("a value beyond its bounds");
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  bool reads = true;
  try {
    const mb::Formula formula(text);
  } catch (const std::domain_error& error) {
    if (*error.what() == '\0') throw std::logic_error("refused without a reason");
    reads = false;
  }
  if (reads && size < 490) try {
      require_same_values(text);
      require_bounds(text);
    } catch (const std::domain_error&) {
      throw std::logic_error("refused in parentheses");
    }
  const std::vector<double> asked_for{0, 0.123456789, 0.5, 1};
  if (!mb::expression_problem(text, 1, asked_for).empty()) return 0;
  if (!reads) throw std::logic_error("no problem, and refused");
  const mb::Formula formula(text);
  for (const double t : asked_for) formula(t);
  for (int i = 1; i < 32; ++i) require_value_or_its_name(formula, i / 31.7);
  return 0;
}
