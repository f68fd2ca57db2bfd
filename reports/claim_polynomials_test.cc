#include <gmock/gmock.h>

#include <optional>
#include <stdexcept>

#include "reports/claims.h"
#include "reports/polynomial_modes.h"
#include "reports/synthetic.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Claim claim(const ReportInput& input) { return claims(evaluate(input)).at(3); }

// Scenes of one body each under a load, or on a floor: its shape and the displacement error of quadratic.
struct OfShape {
  std::string name;
  Shape shape;
  double error, bar = 0;
  std::optional<double> peak_force = std::nullopt;  // [-] error, in contact
};
ReportInput of_shapes(const std::vector<OfShape>& all) {
  ReportInput input;
  for (const OfShape& one : all) {
    Scene& scene = input.scenes.emplace_back(synthetic::scene());
    scene.name = one.name;
    scene.bodies[0].shape = one.shape;
    const auto add = [&](const char* metric, double value) {
      input.records.push_back(synthetic::record(metric, value, one.bar, synthetic::reduced("quadratic", 0)));
      input.records.back().case_name = one.name;
    };
    add("displacement-error", one.error);
    if (!one.peak_force) continue;
    scene.contacts.push_back({.body = scene.bodies[0].name, .obstacle = "floor", .stiffness = 1e9});
    add("peak-force", *one.peak_force);
  }
  return input;
}
Claim polynomials(const std::vector<OfShape>& all) { return claim(of_shapes(all)); }

TEST(Claims, PolynomialModesSufficeForCompactBodiesAndNotForDisparateOnes) {
  const Shape slender = Cylinder{0.05, 0.6}, thin = Box{{10, 10, 1}}, pebble = Superquadric{{3, 2, 1}, 1, 1},
              needle = Superquadric{{6, 1, 1}, 1, 1};
  for (const Shape& compact : {Shape(Cylinder{0.05, 0.5}), Shape(Sphere{1}), pebble}) {
    const Claim good = polynomials({{"a", compact, 0.05}});
    EXPECT_EQ(good.ruling, Ruling::holds_within_limits);
    EXPECT_EQ(good.limits, "holds in a (compact, under loads); disparate bodies: not measured");
    EXPECT_THAT(good.measured, HasSubstr("compact, under loads: 0.0500, at most 10 % in 1 of 1"));
    EXPECT_EQ(polynomials({{"a", compact, 0.2}}).ruling, Ruling::does_not_hold);
    EXPECT_EQ(polynomials({{"a", compact, 0.09, 0.02}}).ruling, Ruling::not_decided);  // 10 % lies within the bar
  }
  for (const Shape& disparate : {slender, thin, needle}) {
    EXPECT_EQ(polynomials({{"a", disparate, 0.2}}).ruling, Ruling::holds_within_limits);
    EXPECT_THAT(polynomials({{"a", disparate, 0.2}}).limits, HasSubstr("; compact bodies: not measured"));
    EXPECT_EQ(polynomials({{"a", disparate, 0.05}}).ruling, Ruling::does_not_hold);
    EXPECT_THAT(polynomials({{"a", disparate, 0.2}}).measured,
                HasSubstr("disparate, under loads: 0.200, at most 10 % in 0 of 1"));
  }
  EXPECT_THAT(polynomials({{"a", thin, 0.2}}).criterion, HasSubstr("disparate"));
}

TEST(Claims, PolynomialModesNeedBothKindsOfBodiesToHold) {
  const auto both = [](double of_compact, double of_disparate) {
    return polynomials({{"ball", Sphere{1}, of_compact}, {"board", Box{{10, 10, 1}}, of_disparate}});
  };
  EXPECT_EQ(both(0.05, 0.2).ruling, Ruling::holds);
  EXPECT_THAT(both(0.05, 0.2).limits, Not(HasSubstr("not measured")));
  EXPECT_EQ(both(0.05, 0.05).ruling, Ruling::holds_within_limits);
  EXPECT_EQ(both(0.2, 0.05).ruling, Ruling::does_not_hold);
  EXPECT_EQ(both(0.2, 0.2).ruling, Ruling::does_not_hold);
}

// Bodies of a scene meet: what compact ones do under loads does not outweigh what they do in contact.
TEST(Claims, PolynomialModesAreJudgedInContactWhereThereIsAny) {
  const OfShape board{"board", Box{{10, 10, 1}}, 0.2}, pushed{"pushed", Sphere{1}, 0.05};
  const auto with = [&](double error, double peak_force) {
    return polynomials({board, pushed, {"dropped", Sphere{1}, error, 0, peak_force}});
  };
  EXPECT_EQ(with(0.05, 0.05).ruling, Ruling::holds);
  EXPECT_EQ(with(0.9, 0.05).ruling, Ruling::does_not_hold);
  EXPECT_EQ(with(0.05, 0.9).ruling, Ruling::does_not_hold);  // the right shape, and the wrong force
  EXPECT_THAT(with(0.05, 0.9).measured, HasSubstr("compact, in contact: 0.900, at most 10 % in 0 of 1"));
  EXPECT_THAT(with(0.05, 0.9).limits, HasSubstr("does not hold in dropped (compact, in contact)"));
  const Claim limited = polynomials({board, {"pushed", Sphere{1}, 0.9}, {"dropped", Sphere{1}, 0.05, 0, 0.05}});
  EXPECT_EQ(limited.ruling, Ruling::holds_within_limits);
}

TEST(Claims, BarsOverSlendernessTakePart) {
  ReportInput input = of_shapes({{"ball", Sphere{1}, 0.05}});
  EXPECT_EQ(claim(input).ruling, Ruling::holds_within_limits);
  Finding table = synthetic::finding(
      "bar", "slenderness", "slenderness",
      {{"load", ""}, {"length/width", "-"}, {"degree", ""}, {"displacement error", "-"}, {"bar", "-"}});
  for (const double ratio : {1.0, 50.0})
    for (const double degree : {1.0, 2.0})
      table.rows.push_back({"bend", ratio, degree, degree == 1 ? 1.0 : ratio == 1 ? 0.06 : 0.3, 1e-3});
  input.findings = {table};
  EXPECT_EQ(claim(input).ruling, Ruling::holds);
  EXPECT_THAT(claim(input).limits, HasSubstr("bar: bend at 50 (disparate, under loads)"));
  EXPECT_THAT(claim(input).measured, HasSubstr("with linear modes alone: compact, under loads: 1.00"));
  input.findings[0].rows[3][3] = 0.06;  // a slender bar that they suffice for
  EXPECT_EQ(claim(input).ruling, Ruling::holds_within_limits);
}

TEST(Claims, PolynomialModesAreJudgedByWhatTheEyeSees) {
  ReportInput input = synthetic::input();
  EXPECT_EQ(claim(input).ruling, Ruling::does_not_hold);  // displacement error 0.12 of quadratic
  for (Record& record : input.records) {
    if (record.contender.method == "quadratic" && record.metric == "displacement-error") record.value = 0.05;
    if (record.metric == "surface-deviation") record.value = 0.9;  // says nothing: it is relative to the body
  }
  EXPECT_EQ(claim(input).ruling, Ruling::holds_within_limits);  // there is no disparate body
  const Sheet table = polynomials_table(evaluate(input));
  ASSERT_EQ(table.rows.size(), 2u);  // linear, quadratic
  EXPECT_EQ(table.rows[0].back().text, "no");
  EXPECT_EQ(table.rows[1].back().text, "yes");
  input.scenes.clear();  // no telling how compact the body is
  EXPECT_EQ(claim(input).ruling, Ruling::not_measured);
}

}  // namespace
}  // namespace mb
