// Formulas from case files: whatever the text, it is refused by a std::domain_error or has the value that it has in
// parentheses, each time again; and what expression_problem lets pass is finite at both
// ends of the duration.
#include <bit>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

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
    } catch (const std::domain_error&) {
      throw std::logic_error("refused in parentheses");
    }
  if (!mb::expression_problem(text, 1).empty()) return 0;
  if (!reads) throw std::logic_error("no problem, and refused");
  const mb::Formula formula(text);
  for (const double t : {0.0, 1.0}) formula(t);
  return 0;
}
