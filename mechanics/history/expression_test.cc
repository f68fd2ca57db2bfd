#include "mechanics/history/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "mechanics/history/history.h"
#include "mechanics/types.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

std::string problem(const std::string& formula) { return expression_problem(formula, 1); }

TEST(ExpressionTest, Grammar) {
  const double t = 0.7;
  const std::pair<const char*, double> meanings[] = {
      {"t", t},
      {" 2 * t ", 2 * t},
      {"-t^2", -t * t},
      {"2^3^2", 512},
      {"2^-1", 0.5},
      {"1 - 2 - 3", -4},
      {"8/4/2", 1},
      {".5e1 + 1.", 6},
      {"sin(pi*t)", std::sin(pi * t)},
      {"ln(exp(t))", t},
      {"log10(1000)", 3},
      {"atan2(1, t)", std::atan2(1, t)},
      {"min(t, 0.2) + max(t,0.2)", 0.9},
      {"abs(sign(-t)) + sqrt(4)", 3},
      {"t < 0.5 ? 1 : 2", 2},
      {"t >= 0.5 && t < 1 || t <= 0", 1},
      {"acos(cos(t))+asin(sin(t))+atan(tan(t))+cosh(0)+sinh(0)+tanh(0)", 3 * t + 1}};
  for (const auto& [formula, expected] : meanings) {
    EXPECT_EQ(problem(formula), "") << formula;
    EXPECT_NEAR(Formula(formula)(t), expected, 1e-15 * std::max(1.0, std::abs(expected)) * 4) << formula;
  }
}

TEST(ExpressionTest, RefusesAndSaysWhere) {
  EXPECT_THAT(problem("0,5"), HasSubstr("comma outside a function call (write decimals with a point) at position 2"));
  EXPECT_THAT(problem("sin(t) + (0,5)"), HasSubstr("comma"));
  EXPECT_THAT(problem("min((1,2),3)"), HasSubstr("comma"));
  EXPECT_THAT(problem("t = 5"), HasSubstr("assignment"));
  EXPECT_THAT(problem("t == 0.015 ? 1/0 : 1"), HasSubstr("'==' is not allowed (use < and >) at position 3"));
  EXPECT_THAT(problem("t != 0.015"), HasSubstr("'!=' is not allowed (use < and >) at position 3"));
  EXPECT_THAT(problem("(t = 5) + 1"), HasSubstr("assignment"));
  EXPECT_THAT(problem("t++"), HasSubstr("an operator lacks a value"));
  EXPECT_THAT(problem("\"text\""), HasSubstr("'\"' is not allowed at position 1"));
  EXPECT_THAT(problem("t\n"), HasSubstr("character that is not allowed at position 2"));
  EXPECT_THAT(problem(std::string("t\0+1", 4)), HasSubstr("position 2"));
  EXPECT_THAT(problem("t\xc2\xb2"), HasSubstr("position 2"));
  EXPECT_THAT(problem(std::string(501, 't')), HasSubstr("500 characters"));
  EXPECT_THAT(problem(std::string(60, '(') + "t" + std::string(60, ')')), HasSubstr("nested"));
}

TEST(ExpressionTest, RefusesWhatTheGrammarHasNot) {
  for (const char* formula : {"",         " ",        "()",    "x",     "2t",       "t t",      "t(2)",    "_pi",
                              "_e",       "e",        "rnd()", "rnd",   "log(2)",   "log2(2)",  "rint(t)", "sum(1,2)",
                              "avg(1,2)", "asinh(t)", "sin t", "sin()", "sin(1,2)", "sin(0,5)", "min(1)",  "max(1,2,3)",
                              "atan2(1)", "1..2",     "1.5.2", "1e",    "0x10",     "--t",      "t+",      "*t",
                              "t)",       "(t",       "t?1",   "t:1",   "t?1:2:3",  "t===1",    "t=!1",    "t&1",
                              "t|1",      "!t",       "t<>1",  "pi=3",  "pi()",     "t()",      "a.b",     "sin",
                              "(,)",      "sin(,)",   ",",     "?:",    "((",       "==",       "1e400"})
    EXPECT_NE(problem(formula), "") << formula;
}

TEST(ExpressionTest, MustBeFiniteAllTheTime) {
  EXPECT_THAT(problem("1/t"), HasSubstr("not finite at t = 0 s"));
  EXPECT_THAT(problem("sqrt(0.5-t)"), HasSubstr("not finite"));
  // the pole lies between any two samples; the search runs up to it, or into it
  EXPECT_THAT(problem("1/(t-0.3)"), ::testing::AnyOf(HasSubstr("unbounded"), HasSubstr("not finite at t = 0.3")));
  EXPECT_THAT(problem("tan(pi*t)"), HasSubstr("unbounded"));
  EXPECT_THAT(problem("exp(1000*t)"), HasSubstr("not finite"));
  EXPECT_EQ(problem("1/(t+0.01)"), "");
  EXPECT_EQ(expression_problem("1/(2-t)", 1), "");
  EXPECT_NE(expression_problem("1/(2-t)", 3), "");
  EXPECT_NE(expression_problem("t", 0), "");
  EXPECT_NE(expression_problem("t", std::nan("")), "");
}

TEST(ExpressionTest, IsFiniteBetweenSamplesToo) {
  for (const char* narrow : {"sqrt(abs(t - 0.0123456) - 1e-6)", "sqrt(abs(t - 0.0123456) - 1e-12)"}) {
    EXPECT_THAT(problem(narrow), HasSubstr("is not finite at t = 0.01234")) << "undefined for 2e-6 s or 2e-12 s";
    EXPECT_THAT([&] { segments(Expression{narrow}, 1); },
                ::testing::ThrowsMessage<std::domain_error>(HasSubstr("is not finite at t = 0.01234")));
  }
  EXPECT_EQ(problem("sqrt(abs(t - 0.0123456))"), "");
  EXPECT_THAT(expression_problem("sqrt(1 - t)", 1, {1.5}), HasSubstr("not finite at t = 1.5")) << "where asked for";
}

TEST(ExpressionTest, EvaluationIsRepeatable) {
  const Formula formula("sin(3*t)/(1+t^2)");
  const double first = formula(0.4);
  formula(0.9);
  EXPECT_EQ(formula(0.4), first);
  const Formula pole("1/(t-0.5)");
  EXPECT_THROW(pole(0.5), std::domain_error);
  EXPECT_EQ(pole(1.5), 1);  // a failure leaves no trace
}

// Random strings of the grammar's own tokens: each is either refused by a domain_error or has a value.
TEST(ExpressionTest, SurvivesHostileText) {
  const char* tokens[] = {"t", "pi",   "1",    "2.5e3",  "0",   "(", ")", ",",  "+",  "-",
                          "*", "/",    "^",    "<",      "=",   ">", "!", "&&", "||", "?",
                          ":", "sin(", "min(", "atan2(", "max", " ", ".", "_",  "e",  "(("};
  std::mt19937 random(11);
  int n_accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    const auto length = 1 + random() % 12;
    for (unsigned j = 0; j < length; ++j) text += tokens[random() % std::size(tokens)];
    try {
      Formula formula(text);
      ++n_accepted;
      formula(0.5);
    } catch (const std::domain_error& error) {
      EXPECT_STRNE(error.what(), "") << text;
    }
  }
  EXPECT_GT(n_accepted, 100);
}

}  // namespace
}  // namespace mb
