#include "cases/scene/number_text.h"

#include <fmt/format.h>

#include <cstdlib>

namespace mb {

namespace {

constexpr int all_digits = 17;  // tell any two numbers apart

double value(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

std::string with_digits(double x, int digits) {
  std::string text = fmt::format("{:.{}g}", x, digits);
  const std::size_t at = text.find('e');
  if (at == std::string::npos) return text;
  if (text[at + 1] == '+') text.erase(at + 1, 1);
  const std::size_t first = text.find_first_of("0123456789", at);
  if (text[first] == '0') text.erase(first, 1);
  return text;
}

}  // namespace

std::string number_text(double x) {
  int digits = 9;
  while (digits < all_digits && value(with_digits(x, digits)) != x) ++digits;
  return with_digits(x, digits);
}

std::string number_beside(double x, double limit) {
  int digits = 3;
  while (digits < all_digits && value(with_digits(x, digits)) == value(with_digits(limit, digits))) ++digits;
  return with_digits(x, digits);
}

double nine_digits(double x) { return value(with_digits(x, 9)); }

}  // namespace mb
