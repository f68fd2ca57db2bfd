#include "reports/claims.h"

#include <gmock/gmock.h>

#include <cmath>

#include "reports/matrix.h"
#include "reports/number.h"
#include "reports/synthetic.h"

namespace mb {
namespace {

using testing::HasSubstr;

Claim claim(const ReportInput& input, const std::string& id) {
  for (const Claim& one : claims(evaluate(input))) {
    if (one.id == id) return one;
  }
  throw std::out_of_range(id);
}

TEST(Claims, AllSixteenAreNamedAndNothingIsMeasuredOfNothing) {
  const auto all = claims(evaluate({}));
  EXPECT_EQ(all.size(), 16u);
  for (const Claim& one : all) EXPECT_EQ(one.ruling, Ruling::not_measured) << one.id;
}

TEST(Claims, SomeMeasuredAndSomeNotMakeLimits) {
  EXPECT_EQ(together({}), Ruling::not_measured);
  EXPECT_EQ(together({Ruling::holds, Ruling::not_measured}), Ruling::holds);
  EXPECT_EQ(together({Ruling::holds, Ruling::does_not_hold}), Ruling::holds_within_limits);
  EXPECT_EQ(together({Ruling::does_not_hold}), Ruling::does_not_hold);
  EXPECT_EQ(together({Ruling::holds_within_limits}), Ruling::holds_within_limits);
}

TEST(Claims, VerdictsFollowTheFindings) {
  ReportInput input = synthetic::input();
  EXPECT_EQ(claim(input, "C2").ruling, Ruling::holds);
  EXPECT_EQ(claim(input, "C7").ruling, Ruling::does_not_hold);  // made for fixed energy; for fixed force it is so
  EXPECT_THAT(claim(input, "C7").limits, HasSubstr("holds in cylinder-compression (force)"));
  EXPECT_THAT(claim(input, "C7").measured, HasSubstr("energy: 1.00"));
  const Claim steps = claim(input, "C6");
  EXPECT_EQ(steps.ruling, Ruling::holds_within_limits);
  EXPECT_THAT(steps.limits, HasSubstr("does not hold in cylinder-compression (explicit Euler)"));
  for (Finding& finding : input.findings) {
    for (auto& row : finding.rows) {
      if (finding.name == "step-limit-exponents") row.back() = "not decided: too few mode counts";
    }
  }
  EXPECT_EQ(claim(input, "C6").ruling, Ruling::not_measured);
  EXPECT_EQ(claim(input, "C6").measured, "");
}

TEST(Claims, TheSpeedUpHoldsFromAHundredOn) {
  for (const double ratio : {99.0, 101.0}) {
    ReportInput input;
    for (const auto& [contender, seconds] :
         {std::pair(synthetic::reduced("eigenmodes", 8), 1.0), std::pair(synthetic::full(2, {1, 2}, 0.01), ratio)}) {
      input.records.push_back(synthetic::record("displacement-error", 5e-3, 0, contender));
      input.records.push_back(synthetic::seconds("online-time", seconds, contender));
    }
    const Claim one = claim(input, "C1");
    EXPECT_EQ(one.ruling, ratio > 100 ? Ruling::holds : Ruling::does_not_hold);
    EXPECT_THAT(one.measured, HasSubstr(format_number(ratio)));
  }
}

TEST(Claims, PolynomialModesSufficeByWhatTheEyeSees) {
  ReportInput input = synthetic::input();
  EXPECT_EQ(claim(input, "C4").ruling, Ruling::does_not_hold);  // displacement error 0.12 of quadratic
  for (Record& record : input.records) {
    if (record.contender.method == "quadratic" && record.metric == "displacement-error") record.value = 0.05;
    if (record.metric == "surface-deviation") record.value = 0.9;  // says nothing: it is relative to the body
  }
  EXPECT_EQ(claim(input, "C4").ruling, Ruling::holds);
}

std::string cell_of(const ReportInput& input, const std::string& contender) {
  const Sheet table = matrix_table(evaluate(input));
  for (const auto& row : table.rows) {
    if (row[0].text == contender) return row[1].text;
  }
  return "";
}

TEST(Matrix, SaysWhatHappenedInSymbolAndNumber) {
  ReportInput input = synthetic::input();
  EXPECT_THAT(cell_of(input, "static-correction"), testing::StartsWith("✔ "));
  EXPECT_THAT(cell_of(input, "static-correction"), HasSubstr("r = 128"));
  EXPECT_THAT(cell_of(input, "quadratic"), testing::StartsWith("▲ 0.12"));
  EXPECT_EQ(cell_of(input, "eigenmodes, explicit-euler"), "⚡ 1 unstable of 1");
  EXPECT_THAT(cell_of(input, "full order, newmark"), HasSubstr("1 failed of 40"));
  for (Record& record : input.records) {
    if (record.contender.method == "linear") record.status = "failed: no memory";
    if (record.contender.method == "quadratic") record.status = "unstable";
  }
  EXPECT_EQ(cell_of(input, "linear"), "✘ 1 failed of 1");
  EXPECT_THAT(cell_of(input, "quadratic"), testing::StartsWith("⚡"));
}

TEST(Matrix, WhatWasNotRunInACaseIsNoFailure) {
  ReportInput input = synthetic::input();
  Record other = synthetic::record("displacement-error", 0.5, 0, synthetic::reduced("other", 1));
  other.case_name = "shear";
  input.records.push_back(other);
  const Sheet table = matrix_table(evaluate(input));
  ASSERT_EQ(table.columns.size(), 3u);
  for (const auto& row : table.rows) EXPECT_TRUE(row[1].text == "– not run" || row[2].text == "– not run");
}

}  // namespace
}  // namespace mb
