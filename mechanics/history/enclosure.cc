#include "mechanics/history/enclosure.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>

#include "mechanics/types.h"

namespace mb {

namespace {

using Binary = Interval (*)(const Interval&, const Interval&);
using Unary = Interval (*)(const Interval&);

constexpr double infinity = std::numeric_limits<double>::infinity();

template <double (*f)(double)>
Interval ascends(const Interval& x) {
  return ascending(f, -infinity, infinity, x);
}
template <double (*f)(double)>
Interval ascends_from_zero(const Interval& x) {
  return ascending(f, 0, infinity, x);
}
Interval arc_sine(const Interval& x) { return ascending(std::asin, -1, 1, x); }
Interval arc_cosine(const Interval& x) { return Interval{pi / 2, pi / 2} - arc_sine(x); }

const std::map<std::string_view, Unary> functions{{"sin", sine},
                                                  {"cos", cosine},
                                                  {"tan", tangent},
                                                  {"asin", arc_sine},
                                                  {"acos", arc_cosine},
                                                  {"atan", ascends<std::atan>},
                                                  {"sinh", ascends<std::sinh>},
                                                  {"cosh", hyperbolic_cosine},
                                                  {"tanh", ascends<std::tanh>},
                                                  {"exp", ascends<std::exp>},
                                                  {"ln", ascends_from_zero<std::log>},
                                                  {"log10", ascends_from_zero<std::log10>},
                                                  {"sqrt", square_root},
                                                  {"abs", absolute},
                                                  {"sign", sign}};
const std::map<std::string_view, Binary> functions_of_two{{"atan2", angle}, {"min", least}, {"max", greatest}};

Interval greater(const Interval& x, const Interval& y) { return less(y, x); }
Interval at_least(const Interval& x, const Interval& y) { return at_most(y, x); }
Interval sum(const Interval& x, const Interval& y) { return x + y; }
Interval difference(const Interval& x, const Interval& y) { return x - y; }
Interval product(const Interval& x, const Interval& y) { return x * y; }
Interval quotient(const Interval& x, const Interval& y) { return x / y; }

// Operators from the left, the loosest first.
struct Operator {
  std::string_view text;
  Binary of;
};
const std::vector<std::vector<Operator>> levels{{{"||", either}},
                                                {{"&&", both}},
                                                {{"<=", at_most}, {">=", at_least}, {"<", less}, {">", greater}},
                                                {{"+", sum}, {"-", difference}},
                                                {{"*", product}, {"/", quotient}}};

Enclosure composed(Binary f, Enclosure x, Enclosure y) {
  return [f, x = std::move(x), y = std::move(y)](const Interval& t) { return f(x(t), y(t)); };
}
Enclosure composed(Unary f, Enclosure x) {
  return [f, x = std::move(x)](const Interval& t) { return f(x(t)); };
}
Enclosure enclosed(Interval constant) {
  return [constant](const Interval&) { return constant; };
}
Enclosure chosen(Enclosure condition, Enclosure x, Enclosure y) {
  return [condition = std::move(condition), x = std::move(x), y = std::move(y)](const Interval& t) {
    const Interval holds = condition(t);
    if (!may_fail(holds)) return x(t);
    return may_hold(holds) ? hull(x(t), y(t)) : y(t);
  };
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Enclosure whole() {
    Enclosure result = choice();
    if (at_ < text_.size()) fail();
    return result;
  }

 private:
  [[noreturn]] void fail() const { throw std::domain_error(fmt::format("not understood at position {}", at_ + 1)); }
  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(std::string_view token) {
    skip_blanks();
    if (text_.substr(at_, token.size()) != token) return false;
    at_ += token.size();
    skip_blanks();
    return true;
  }
  void require(std::string_view token) {
    if (!take(token)) fail();
  }

  Enclosure choice() {
    Enclosure condition = chain(0);
    if (!take("?")) return condition;
    Enclosure x = choice();
    require(":");
    return chosen(std::move(condition), std::move(x), choice());
  }
  Enclosure chain(std::size_t level) {
    if (level == levels.size()) return signed_power();
    Enclosure result = chain(level + 1);
    while (const Operator* found = operator_of(level))
      result = composed(found->of, std::move(result), chain(level + 1));
    return result;
  }
  const Operator* operator_of(std::size_t level) {
    for (const Operator& candidate : levels[level])
      if (take(candidate.text)) return &candidate;
    return nullptr;
  }
  Enclosure signed_power() {  // -t^2 = -(t^2), 2^-1 = 2^(-1), 2^3^2 = 2^(3^2)
    if (take("-")) return composed([](const Interval& x) { return -x; }, signed_power());
    if (take("+")) return signed_power();
    Enclosure base = primary();
    return take("^") ? composed(power, std::move(base), signed_power()) : base;
  }
  Enclosure primary() {
    if (take("(")) return parenthesised();
    if (at_ < text_.size() && (text_[at_] == '.' || (text_[at_] >= '0' && text_[at_] <= '9'))) return number();
    const std::string_view name = word();
    if (name == "t") return [](const Interval& t) { return t; };
    if (name == "pi") return enclosed({pi, pi});
    require("(");
    if (const auto one = functions.find(name); one != functions.end()) return composed(one->second, parenthesised());
    const auto two = functions_of_two.find(name);
    if (two == functions_of_two.end()) fail();
    Enclosure x = choice();
    require(",");
    return composed(two->second, std::move(x), parenthesised());
  }
  Enclosure parenthesised() {
    Enclosure inside = choice();
    require(")");
    return inside;
  }
  Enclosure number() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    const bool vanishes = error == std::errc::result_out_of_range;  // 1e-999: muParser refuses what is too large
    if (error != std::errc() && !vanishes) fail();
    at_ = static_cast<std::size_t>(end - text_.data());
    skip_blanks();
    return vanishes ? enclosed({0, std::numeric_limits<double>::min()}) : enclosed({value, value});
  }
  std::string_view word() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) ++at_;
    const std::string_view name = text_.substr(start, at_ - start);
    skip_blanks();
    return name;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Enclosure enclosure(const std::string& formula) { return Reader(formula).whole(); }

}  // namespace mb
