#include "mechanics/history/interval.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "mechanics/types.h"

namespace mb {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Interval anything() { return {-infinity, infinity, false}; }

// Bounds found, each n ulp further out. What is no number, such as inf - inf, may be anything.
Interval outward(double lo, double hi, bool defined, int n) {
  if (std::isnan(lo) || std::isnan(hi)) return anything();
  for (int i = 0; i < n; ++i) {
    lo = std::nextafter(lo, -infinity);
    hi = std::nextafter(hi, infinity);
  }
  return {lo, hi, defined};
}

Interval outward(std::initializer_list<double> corners, bool defined, int n) {
  for (const double c : corners)
    if (std::isnan(c)) return anything();
  return outward(std::min(corners), std::max(corners), defined, n);
}

bool both_defined(const Interval& x, const Interval& y) { return x.defined && y.defined; }
bool may_be_infinite(const Interval& x) { return x.lo == -infinity || x.hi == infinity; }
bool holds_zero(const Interval& x) { return x.lo <= 0 && x.hi >= 0; }
bool is_integer(const Interval& y) { return y.lo == y.hi && y.lo == std::floor(y.lo) && std::abs(y.lo) < 1e9; }

// Whole numbers stay exact, so that (t - 1)^(1 + 1) is known to be a square.
bool is_exact(const Interval& x, const Interval& y) {
  return is_integer(x) && is_integer(y) && std::abs(x.lo * y.lo) < 1e9;
}
Interval whole(double n, bool defined) { return {n, n, defined}; }

// Whether some  phase + n period  lies in x, ends widened by the rounding of the quotient.
bool meets(const Interval& x, double phase, double period) {
  const double from = (x.lo - phase) / period, to = (x.hi - phase) / period;
  const double rounding = 1e-15 * std::max({std::abs(from), std::abs(to), 1.0});
  return std::floor(to + rounding) >= std::ceil(from - rounding);
}

Interval condition(bool may_be_true, bool may_be_false) { return {may_be_false ? 0.0 : 1.0, may_be_true ? 1.0 : 0.0}; }

Interval integer_power(const Interval& x, double n) {
  if (n < 0 && holds_zero(x)) return anything();
  const double a = std::pow(x.lo, n), b = std::pow(x.hi, n);
  Interval result = outward({a, b}, x.defined, 4);
  if (n > 0 && holds_zero(x) && std::fmod(n, 2) == 0) result.lo = 0;
  return result;
}

}  // namespace

// Numbers too large for a double are infinite there: infinity less infinity, by infinity or times 0 is none.
Interval operator+(const Interval& x, const Interval& y) {
  if (is_exact(x, y)) return whole(x.lo + y.lo, both_defined(x, y));
  const bool opposed = (x.hi == infinity && y.lo == -infinity) || (x.lo == -infinity && y.hi == infinity);
  return opposed ? anything() : outward(x.lo + y.lo, x.hi + y.hi, both_defined(x, y), 1);
}
Interval operator-(const Interval& x, const Interval& y) {
  if (is_exact(x, y)) return whole(x.lo - y.lo, both_defined(x, y));
  const bool alike = (x.hi == infinity && y.hi == infinity) || (x.lo == -infinity && y.lo == -infinity);
  return alike ? anything() : outward(x.lo - y.hi, x.hi - y.lo, both_defined(x, y), 1);
}
Interval operator-(const Interval& x) { return {-x.hi, -x.lo, x.defined}; }
Interval operator*(const Interval& x, const Interval& y) {
  if (is_exact(x, y)) return whole(x.lo * y.lo, both_defined(x, y));
  if ((may_be_infinite(x) && holds_zero(y)) || (holds_zero(x) && may_be_infinite(y))) return anything();
  return outward({x.lo * y.lo, x.lo * y.hi, x.hi * y.lo, x.hi * y.hi}, both_defined(x, y), 1);
}
Interval operator/(const Interval& x, const Interval& y) {
  if (holds_zero(y) || (may_be_infinite(x) && may_be_infinite(y))) return anything();
  return outward({x.lo / y.lo, x.lo / y.hi, x.hi / y.lo, x.hi / y.hi}, both_defined(x, y), 1);
}
Interval hull(const Interval& x, const Interval& y) {
  return {std::min(x.lo, y.lo), std::max(x.hi, y.hi), both_defined(x, y)};
}

Interval power(const Interval& x, const Interval& y) {
  if (is_integer(y))
    return y.lo == 0 ? Interval{1, 1, x.defined} : integer_power({x.lo, x.hi, both_defined(x, y)}, y.lo);
  const bool defined = both_defined(x, y) && (x.lo > 0 || (x.lo == 0 && y.lo > 0));
  const bool may_be_integer = std::floor(y.hi) >= y.lo;  // of which negative numbers have powers, too
  if (x.hi < 0 || (y.lo <= 0 && x.lo <= 0) || (x.lo < 0 && may_be_integer)) return anything();
  const double base = std::max(x.lo, 0.0);  // monotonic in each of the two: largest and least at corners
  return outward({std::pow(base, y.lo), std::pow(base, y.hi), std::pow(x.hi, y.lo), std::pow(x.hi, y.hi)}, defined, 4);
}

Interval ascending(double (*f)(double), double from, double to, const Interval& x) {
  const double lo = std::max(x.lo, from), hi = std::min(x.hi, to);
  if (!(lo <= hi)) return anything();
  return outward(f(lo), f(hi), x.defined && x.lo >= from && x.hi <= to, 4);
}

Interval square_root(const Interval& x) { return ascending(std::sqrt, 0, infinity, x); }

Interval absolute(const Interval& x) {
  const double a = std::abs(x.lo), b = std::abs(x.hi);
  return {holds_zero(x) ? 0 : std::min(a, b), std::max(a, b), x.defined};
}

Interval sign(const Interval& x) {
  const auto of = [](double value) { return static_cast<double>((value > 0) - (value < 0)); };
  return {of(x.lo), of(x.hi), x.defined};
}

Interval least(const Interval& x, const Interval& y) {
  return {std::min(x.lo, y.lo), std::min(x.hi, y.hi), both_defined(x, y)};
}
Interval greatest(const Interval& x, const Interval& y) {
  return {std::max(x.lo, y.lo), std::max(x.hi, y.hi), both_defined(x, y)};
}

Interval sine(const Interval& x) {
  if (!(std::abs(x.lo) < infinity && std::abs(x.hi) < infinity)) return anything();
  Interval result = outward({std::sin(x.lo), std::sin(x.hi)}, x.defined, 4);
  if (meets(x, pi / 2, 2 * pi)) result.hi = 1;
  if (meets(x, -pi / 2, 2 * pi)) result.lo = -1;
  return result;
}
Interval cosine(const Interval& x) {
  if (!(std::abs(x.lo) < infinity && std::abs(x.hi) < infinity)) return anything();
  Interval result = outward({std::cos(x.lo), std::cos(x.hi)}, x.defined, 4);
  if (meets(x, 0, 2 * pi)) result.hi = 1;
  if (meets(x, pi, 2 * pi)) result.lo = -1;
  return result;
}
Interval tangent(const Interval& x) {
  if (!(x.hi - x.lo < pi) || meets(x, pi / 2, pi)) return anything();
  return outward(std::tan(x.lo), std::tan(x.hi), x.defined, 4);
}
Interval hyperbolic_cosine(const Interval& x) {
  const Interval size = absolute(x);
  return outward(std::cosh(size.lo), std::cosh(size.hi), x.defined, 4);
}

// Beside the origin and the cut along x < 0, the directions to a box are bounded by those to its corners.
Interval angle(const Interval& y, const Interval& x) {
  if (holds_zero(y) && x.lo <= 0) return {std::nextafter(-pi, -4), std::nextafter(pi, 4), both_defined(x, y)};
  return outward({std::atan2(y.lo, x.lo), std::atan2(y.lo, x.hi), std::atan2(y.hi, x.lo), std::atan2(y.hi, x.hi)},
                 both_defined(x, y), 4);
}

Interval less(const Interval& x, const Interval& y) {
  const bool defined = both_defined(x, y);  // no number is less than none
  return condition(!defined || x.lo < y.hi, !defined || x.hi >= y.lo);
}
Interval at_most(const Interval& x, const Interval& y) {
  const bool defined = both_defined(x, y);
  return condition(!defined || x.lo <= y.hi, !defined || x.hi > y.lo);
}
Interval both(const Interval& x, const Interval& y) {
  return condition(may_hold(x) && may_hold(y), may_fail(x) || may_fail(y));
}
Interval either(const Interval& x, const Interval& y) {
  return condition(may_hold(x) || may_hold(y), may_fail(x) && may_fail(y));
}
bool may_hold(const Interval& condition) { return !(condition.lo == 0 && condition.hi == 0) || !condition.defined; }
bool may_fail(const Interval& condition) { return holds_zero(condition) || !condition.defined; }

}  // namespace mb
