#include "mechanics/history/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "mechanics/types.h"

namespace mb {
namespace {

constexpr std::size_t longest =
    500;  // characters; muParser copies the text once a token, so that time grows quadratically
constexpr std::size_t deepest = 50;  // nested parentheses

bool is_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

// Last character before i that is not blank, or '\0'.
char before(std::string_view text, std::size_t i) {
  while (i > 0)
    if (text[--i] != ' ') return text[i];
  return '\0';
}

bool is_comparison(std::string_view text, std::size_t i) {  // the '=' at i belongs to <= >=
  return i > 0 && (text[i - 1] == '<' || text[i - 1] == '>');
}

// One sentence, or empty.
std::string refusal(std::string_view text) {
  if (text.size() > longest) return fmt::format("the formula has more than {} characters", longest);
  std::vector<bool> in_call;  // one entry an open parenthesis
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto at = [&](std::string_view what) { return fmt::format("{} at position {}", what, i + 1); };
    if (const auto two = text.substr(i, 2); two == "==" || two == "!=")
      return at(fmt::format("'{}' is not allowed (use < and >)", two));
    if (!is_name(c) && std::string_view(" +-*/^(),.<>=&|?:").find(c) == std::string_view::npos)
      return at(c > ' ' && c <= '~' ? fmt::format("'{}' is not allowed", c) : "a character that is not allowed");
    if (c == '=' && !is_comparison(text, i)) return at("assignment is not allowed: '='");
    if (c == '(') in_call.push_back(is_name(before(text, i)));
    if (in_call.size() > deepest) return at(fmt::format("more than {} nested parentheses", deepest));
    if (c == ')' && !in_call.empty()) in_call.pop_back();
    if (c == ',' && (in_call.empty() || !in_call.back()))
      return at("a comma outside a function call (write decimals with a point)");
  }
  return {};
}

double least(double a, double b) { return std::min(a, b); }
double greatest(double a, double b) { return std::max(a, b); }
double signum(double x) { return (x > 0) - (x < 0); }

void define_vocabulary(mu::Parser& parser) {
  struct Function {
    const char* name;
    double (*value)(double);
  };
  static constexpr Function functions[] = {
      {"sin", std::sin},   {"cos", std::cos},     {"tan", std::tan},   {"asin", std::asin}, {"acos", std::acos},
      {"atan", std::atan}, {"sinh", std::sinh},   {"cosh", std::cosh}, {"tanh", std::tanh}, {"exp", std::exp},
      {"ln", std::log},    {"log10", std::log10}, {"sqrt", std::sqrt}, {"abs", std::abs},   {"sign", signum}};
  parser.ClearFun();
  parser.ClearConst();
  parser.DefineConst("pi", pi);
  for (const auto& function : functions) parser.DefineFun(function.name, function.value);
  parser.DefineFun("atan2", static_cast<double (*)(double, double)>(std::atan2));
  parser.DefineFun("min", least);
  parser.DefineFun("max", greatest);
}

}  // namespace

struct Formula::Compiled {
  mu::Parser parser;
  double t = 0;
  std::string text;
};

Formula::Formula(const std::string& formula) : compiled_(std::make_unique<Compiled>()) {
  if (const auto why = refusal(formula); !why.empty()) throw std::domain_error(why);
  compiled_->text = formula;
  auto& parser = compiled_->parser;
  try {
    define_vocabulary(parser);
    parser.DefineVar("t", &compiled_->t);
    parser.EnableOptimizer(false);  // it rearranges terms, so that rounding would depend on how a formula is written
    parser.SetExpr(formula);
    int n_results = 0;
    parser.Eval(n_results);  // the first evaluation compiles
    if (n_results != 1) throw std::domain_error("the formula has more than one value");
  } catch (const mu::ParserError& error) {
    auto why =
        error.GetCode() == mu::ecINTERNAL_ERROR ? "the formula is not one: an operator lacks a value" : error.GetMsg();
    while (!why.empty() && (why.back() == '.' || why.back() == ' ')) why.pop_back();
    throw std::domain_error(why);
  }
}

Formula::~Formula() = default;

double Formula::operator()(double t) const {
  double s = 0;
  try {
    compiled_->t = t;
    s = compiled_->parser.Eval();
  } catch (const mu::ParserError& error) {
    throw std::domain_error(error.GetMsg());
  }
  if (!std::isfinite(s))
    throw std::domain_error(fmt::format("\"{}\" is not finite at t = {:.6g} s", compiled_->text, t));
  return s;
}

}  // namespace mb
