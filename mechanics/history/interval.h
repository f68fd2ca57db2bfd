// Intervals that hold every value of a function on an interval, rounding included:
//
//   { f(x) : x in X, f(x) defined }  is a part of  [lo, hi] = f(X)
//
// Bounds are widened by what an operation may round: 1 ulp of + - * / sqrt, 4 ulp of the functions of libm (below 2
// are known: Gladman et al., Accuracy of Mathematical Functions, 2024). Conditions are intervals as well: [1, 1] holds,
// [0, 0] does not, [0, 1] is undecided.
#pragma once

namespace mb {

struct Interval {
  double lo, hi;        // lo <= hi, both may be infinite
  bool defined = true;  // false: on some part there may be no number
};

Interval operator+(const Interval& x, const Interval& y);
Interval operator-(const Interval& x, const Interval& y);
Interval operator*(const Interval& x, const Interval& y);
Interval operator/(const Interval& x, const Interval& y);
Interval operator-(const Interval& x);
Interval hull(const Interval& x, const Interval& y);

Interval power(const Interval& x, const Interval& y);
Interval square_root(const Interval& x);
Interval absolute(const Interval& x);
Interval sign(const Interval& x);
Interval least(const Interval& x, const Interval& y);
Interval greatest(const Interval& x, const Interval& y);
Interval sine(const Interval& x);
Interval cosine(const Interval& x);
Interval tangent(const Interval& x);
Interval hyperbolic_cosine(const Interval& x);
Interval angle(const Interval& y, const Interval& x);  // atan2(y, x)
// Of a function that ascends on [from, to] and has no value elsewhere.
Interval ascending(double (*f)(double), double from, double to, const Interval& x);

Interval less(const Interval& x, const Interval& y);     // x < y
Interval at_most(const Interval& x, const Interval& y);  // x <= y
Interval both(const Interval& x, const Interval& y);     // x && y
Interval either(const Interval& x, const Interval& y);   // x || y
bool may_hold(const Interval& condition);                // some of it is not 0
bool may_fail(const Interval& condition);                // some of it is 0

}  // namespace mb
