// A formula in t, compiled once. The only door of muParser, held to a closed grammar of our own:
//
//   numbers, t [s], pi;   + - * / ^ (right-associative, above the sign: -t^2 = -(t^2));   < <= > >= && || ? :
//   sin cos tan asin acos atan sinh cosh tanh exp ln log10 sqrt abs sign,   atan2(y, x) min(a, b) max(a, b)
//
// Refused: == and !=, which tell single instants apart that no search finds; assignment; a comma outside a call
// (muParser reads `0,5` as 5); strings; every other character; more than 500 characters or 50 nested parentheses.
// muParser's own constants (_pi, _e) and functions are not taken over: `log` means two things, and a function that a
// later version adds (such as `rnd`) must not change what a case file means.
#pragma once

#include <memory>
#include <string>

namespace mb {

class Formula {
 public:
  explicit Formula(const std::string& formula);  // throws std::domain_error, whose text says what is wrong and where
  ~Formula();
  Formula(const Formula&) = delete;
  Formula& operator=(const Formula&) = delete;

  // Throws std::domain_error where the value is not finite. Not for two threads at once: muParser reads t from memory.
  double operator()(double t) const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
};

}  // namespace mb
