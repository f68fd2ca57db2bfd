#include "reports/orders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reports/figures.h"
#include "reports/synthetic.h"

namespace mb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<OrderPoint> power_law(double p, double floor, int n, double hidden = 0) {
  std::vector<OrderPoint> points;
  for (int i = 0; i < n; ++i) {
    const double h = std::pow(0.5, i);
    points.push_back({h, std::hypot(0.3 * std::pow(h, p), floor), hidden});
  }
  return points;
}

TEST(ObservedOrders, APowerLawIsRecoveredExactly) {
  for (const double p : {0.5, 1.0, 2.0, 4.0}) {
    const ObservedOrder order = fit_order(power_law(p, 0, 6));
    EXPECT_NEAR(order.order, p, 1e-12);  // rounding of logarithms
    EXPECT_LT(order.standard_error, 1e-12);
    EXPECT_EQ(order.n_points, 6);
    EXPECT_EQ(order.n_left_out, 0);
  }
}

TEST(ObservedOrders, TheOrderOfThePointsDoesNotMatter) {
  std::vector<OrderPoint> points = power_law(2, 0, 5);
  std::swap(points[0], points[3]);
  EXPECT_NEAR(fit_order(points).order, 2, 1e-12);
}

TEST(ObservedOrders, FlattenedTailsAreLeftOut) {
  for (const double p : {1.0, 2.0}) {
    const ObservedOrder order = fit_order(power_law(p, 1e-3, 16));
    EXPECT_NEAR(order.order, p, 0.05 * p);  // a floor at a third of the last point bends it by 6 % at most
    EXPECT_GE(order.n_points, 3);
    EXPECT_GT(order.n_left_out, 5);
    EXPECT_LT(order.n_points + order.n_left_out, 17);
  }
}

TEST(ObservedOrders, PointsNearTheBarAndUnresolvedOnesAreLeftOut) {
  std::vector<OrderPoint> points = power_law(2, 0, 8, 1e-3);  // 0.3 4^-i > 5e-3 for i <= 2
  EXPECT_EQ(fit_order(points).n_points, 3);
  points.push_back({4, 7, 0});  // unresolved, and off the law
  EXPECT_EQ(fit_order(points).n_points, 3);
  EXPECT_NEAR(fit_order(points).order, 2, 1e-12);
}

TEST(ObservedOrders, ScatterShowsInTheStandardError) {
  std::vector<OrderPoint> points = power_law(1, 0, 6);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].error *= i % 2 ? 1.1 : 1 / 1.1;
  const ObservedOrder order = fit_order(points);
  EXPECT_GT(order.standard_error, 0.01);
  EXPECT_NEAR(order.order, 1, 3 * order.standard_error);
}

TEST(ObservedOrders, FewerThanThreePointsHaveNoOrder) {
  EXPECT_TRUE(std::isnan(fit_order({}).order));
  EXPECT_TRUE(std::isnan(fit_order(power_law(1, 0, 2)).order));
  EXPECT_TRUE(std::isnan(fit_order({{1, 0.1, 0}, {1, 0.1, 0}, {1, 0.1, 0}}).order));  // one step, three times
  const ObservedOrder bad = fit_order({{1, nan, 0}, {0.5, 0.1, nan}, {0, 0.1, 0}, {-1, 0.2, 0}, {0.25, 0, 0}});
  EXPECT_TRUE(std::isnan(bad.order));
}

TEST(ObservedOrders, ErrorsThatDoNotFallHaveNoFineOrder) {
  std::vector<OrderPoint> rising = {{1, 0.1, 0}, {0.5, 0.2, 0}, {0.25, 0.4, 0}};
  EXPECT_TRUE(std::isnan(fit_order(rising).order));
  EXPECT_EQ(fit_order(rising).why_none, "error does not fall");
  EXPECT_EQ(fit_order({{1, 0.1, 0}, {0.5, 0.1, 0}, {0.25, 0.1, 0}}).why_none, "error does not fall");
  EXPECT_EQ(fit_order(power_law(0.05, 0, 4)).why_none, "error does not fall");
  EXPECT_EQ(fit_order({{1, 0.1, 0}, {0.5, 0.02, 0}, {0.25, 0.09, 0}, {0.125, 0.018, 0}}).why_none,
            "error does not fall");  // by scatter
  EXPECT_EQ(fit_order(power_law(1, 0, 2)).why_none, "fewer than three points");
  EXPECT_EQ(fit_order(power_law(1, 0, 3)).why_none, "");
}

TEST(ObservedOrders, AnErrorThatDoesNotFallIsNoneInTheTableAndHasNoLegend) {
  ReportInput input;
  for (const double step : {0.01, 0.005, 0.0025}) {  // the coarser the step, the less the error: the mesh's rules
    input.records.push_back(synthetic::record("displacement-error", 0.1 - step, 0, synthetic::full(2, {1, 2}, step)));
  }
  const Evaluation evaluation = evaluate(input);
  const std::vector<Curve> all = curves(evaluation);
  const Sheet table = orders_table(all);
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.rows[0][9].text, "none");
  EXPECT_EQ(table.rows[0].back().text, "error does not fall");
  const mb::Run& run = evaluation.runs[0];
  EXPECT_TRUE(
      order_labels(all, run, run.measures.begin()->first, true, drawn(evaluation.runs), evaluation.runs).empty());
}

class Curves : public ::testing::Test {
 protected:
  Evaluation evaluation_ = evaluate(synthetic::input());
  std::vector<Curve> all_ = curves(evaluation_);
  const Curve& find(const std::string& method, const std::string& integrator, Refinement refinement, int r,
                    const std::string& truth = "same_mesh") {
    for (const Curve& curve : all_) {
      const bool same = curve.contender.method == method && curve.contender.integrator == integrator &&
                        curve.refinement == refinement && curve.measure.metric == "displacement-error" &&
                        curve.measure.truth == truth && (r < 0 || curve.contender.settings.modes == r);
      if (same) return curve;
    }
    throw std::out_of_range(method + integrator);
  }
};

TEST_F(Curves, OrdersInRAreThoseOfTheStudy) {
  // error ~ (1 + r)^-p: steeper than r^-p nowhere, flatter by up to a half at r = 1
  EXPECT_NEAR(find("eigenmodes", "exact", Refinement::modes, -1).observed.order, 0.8, 0.1);
  EXPECT_NEAR(find("static-correction", "exact", Refinement::modes, -1).observed.order, 1.5, 0.2);
}

TEST_F(Curves, OrdersInTheStepGoDownToTheErrorOfTheBasis) {
  EXPECT_NEAR(find("static-correction", "newmark", Refinement::step, 128).observed.order, 2, 0.05);
  EXPECT_NEAR(find("static-correction", "symplectic-euler", Refinement::step, 128).observed.order, 1, 0.05);
  EXPECT_GT(find("static-correction", "newmark", Refinement::step, 8).observed.n_left_out, 1);
}

TEST_F(Curves, TolerancesAndFullOrderHaveCurvesToo) {
  EXPECT_NEAR(find("full-order", "sundials", Refinement::tolerance, -1).observed.order, 0.9, 0.05);
  EXPECT_NO_THROW(find("full-order", "newmark", Refinement::step, -1, "finer"));
  EXPECT_NO_THROW(find("full", "central-difference", Refinement::step, -1));
}

TEST_F(Curves, TheTableHasOneRowACurve) {
  const Sheet table = orders_table(all_);
  EXPECT_EQ(table.rows.size(), all_.size());
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

TEST(Drawings, OnlyTheSmallestStepStandsAgainstModesAndTheLargestRAgainstSteps) {
  const Evaluation evaluation = evaluate(synthetic::input());
  const std::vector<Drawn> all = drawn(evaluation.runs);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Contender& c = evaluation.runs[i].contender;
    if (c.method != "static-correction" || c.integrator != "newmark") continue;
    EXPECT_EQ(all[i].against_modes, c.settings.time_step == 0.0005);
    EXPECT_EQ(all[i].against_step, c.settings.modes == 128);
  }
}

}  // namespace
}  // namespace mb
