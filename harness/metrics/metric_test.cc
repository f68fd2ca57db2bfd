#include "harness/metrics/metric.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace mb {
namespace {

using ::testing::StartsWith;

constexpr Index n_t = 60, n_volume = 30, n_surface = 20;
constexpr double rate = 100, seconds = (n_t - 1) / rate;

// A box with points of our own: what quadrature gives them does not matter here.
struct Setting {
  Scene scene;
  EvaluationPoints points;
  MetricContext context(bool free = true, Index probe = -1) const { return {scene, 0, points, free, probe}; }
};

Setting setting() {
  Setting s;
  s.scene.bodies = {{.name = "block",
                     .shape = Box{{0.1, 0.2, 0.4}},
                     .material = {.youngs_modulus = 2e4, .poissons_ratio = 0.3, .density = 1100},
                     .damping = {},
                     .damping_ratios = {},
                     .resolution = {1, {1, 1, 1}},
                     .supports = {}}};
  s.scene.probes = {{"other", "elsewhere", {0, 0, 0}, {1, 0, 0}}, {"top", "block", {0, 0, 0.2}, {0, 0, 1}}};
  s.scene.samples_per_second = rate;
  const auto scattered = [](Index n) -> Matrix3Xd {
    return Vector3d(0.05, 0.1, 0.2).asDiagonal() * Matrix3Xd::Random(3, n);
  };
  s.points.volume = {scattered(n_volume), VectorXd::Random(n_volume).array() + 1.5};
  s.points.surface = {scattered(n_surface), VectorXd::Ones(n_surface)};
  s.points.probes = Matrix3Xd::Zero(3, 1);
  s.points.probes(2, 0) = 0.2;
  return s;
}

// x(t) = R(t) (I + a sin(omega t) E) X + c(t): a uniform strain, a spin and a flight.
Trajectory answer(const Setting& s, double a, double spin = 0, const Vector3d& velocity = Vector3d::Zero(),
                  double frequency = 2) {
  const Matrix3Xd X = s.points.all();
  const Eigen::Matrix3d E = Vector3d(-0.3, -0.3, 1).asDiagonal();
  Trajectory result;
  result.t = VectorXd::LinSpaced(n_t, 0, seconds);
  result.bodies = {{MatrixXd(X.size(), n_t), MatrixXd(6 * s.points.n_strained(), n_t)}};
  for (Index k = 0; k < n_t; ++k) {
    const double t = result.t(k), stretch = a * std::sin(2 * pi * frequency * t);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(spin * t, Vector3d(1, 2, 2).normalized()).toRotationMatrix();
    const Matrix3Xd x = (R * (X + stretch * E * X)).colwise() + velocity * t;
    result.bodies[0].displacement.col(k) = (x - X).reshaped();
    const Eigen::Vector<double, 6> eps{-0.3 * stretch, -0.3 * stretch, stretch, 0, 0, 0};
    result.bodies[0].strain.col(k) = eps.replicate(s.points.n_strained(), 1);
  }
  return result;
}

double value(const std::string& name, const Trajectory& a, const Trajectory& b, const MetricContext& context) {
  return mark(metric(name), a, b, context).value;
}

TEST(MetricCatalogue, NamesAreUniqueAndFound) {
  std::set<std::string> names;
  for (const Metric& m : metric_catalogue()) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_EQ(m.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos) << m.name;
    EXPECT_FALSE(m.doc.empty());
    EXPECT_EQ(&metric(m.name), &m);
  }
  EXPECT_THROW(metric("beauty"), std::out_of_range);
}

TEST(Metrics, AnAnswerThatIsTheTruthHasNoError) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01, 2, {1, 0, 3});
  for (const Metric& m : metric_catalogue()) {
    if (m.of_truth_alone || m.contact_only || m.finite_only) continue;
    const Mark result = mark(m, truth, truth, s.context(true, 1));
    EXPECT_EQ(result.status, "ok") << m.name;
    EXPECT_EQ(result.value, 0) << m.name;
    EXPECT_EQ(distance(m, truth, truth, s.context(true, 1)), 0) << m.name;
  }
}

TEST(Metrics, ATenthTooMuchDeformationIsATenth) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01), a = answer(s, 0.011);
  EXPECT_NEAR(value("displacement-error", a, truth, s.context(false)), 0.1, 1e-12);
  // Stretching scattered points also turns their best frame a little, by an angle of the order of the strain 0.01: the
  // two frames differ by its square.
  EXPECT_NEAR(value("displacement-error", a, truth, s.context()), 0.1, 1e-4);
  EXPECT_NEAR(value("strain-error", a, truth, s.context()), 0.1, 1e-12);
  EXPECT_NEAR(value("probe-error", a, truth, s.context(true, 1)), 0.1, 1e-12);
  EXPECT_NEAR(value("probe-magnitude", a, truth, s.context(true, 1)), 0.1, 1e-12);
  EXPECT_NEAR(value("probe-magnitude", answer(s, 0.009), truth, s.context(true, 1)), -0.1, 1e-12);
  EXPECT_NEAR(value("probe-phase", a, truth, s.context(true, 1)), 0, 1e-12);
  EXPECT_LT(value("pose-rotation", a, truth, s.context()), 1e-3);
}

TEST(Metrics, StrainErrorIsThatOfTheEnergy) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01);
  Trajectory sheared = truth;
  // Shear carries G gamma^2, the truth eps:C:eps = (E + ...) a^2 with uniaxial stress: E a^2. Both at every point.
  for (Index p = 0; p < n_volume; ++p) sheared.bodies[0].strain.row(6 * p + 3) = truth.bodies[0].strain.row(6 * p + 2);
  const double E = 2e4, G = E / 2.6;
  EXPECT_NEAR(value("strain-error", sheared, truth, s.context()), std::sqrt(G / E), 1e-12);
}

TEST(Metrics, DeformationErrorDoesNotSeeRigidMotion) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01), a = answer(s, 0.012);
  const Trajectory flying_truth = answer(s, 0.01, 3, {0.5, 1, -9}), flying = answer(s, 0.012, -1, {2, 0, 0});
  for (const char* name : {"displacement-error", "surface-deviation"}) {
    const double expected = value(name, a, truth, s.context());
    // Rounding of positions of 5 m against deformations of 1 mm.
    EXPECT_NEAR(value(name, flying, truth, s.context()), expected, 1e-11);
    EXPECT_NEAR(value(name, a, flying_truth, s.context()), expected, 1e-11);
    EXPECT_NEAR(value(name, flying, flying_truth, s.context()), expected, 1e-11);
    // A body that is held shows every difference.
    EXPECT_GT(value(name, flying, truth, s.context(false)), 100 * expected);
  }
}

TEST(Metrics, SurfaceDeviationIsRelativeToTheBody) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0);
  Trajectory bump = truth;
  bump.bodies[0].displacement(3 * (n_volume + 4) + 1, 30) = 0.002;  // one surface point at one time
  EXPECT_NEAR(value("surface-deviation", bump, truth, s.context()), 0.002 / 0.4, 1e-14);
}

TEST(Metrics, PoseOfASpinningFlyingBody) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01, 2.0, {1, 0, 0}), a = answer(s, 0.01, 2.5, {1, 0, 0.2});
  EXPECT_NEAR(value("pose-rotation", a, truth, s.context()), 0.5 * seconds, 1e-12);
  // The centroid of the points is not the centre of the spin: its offset, below 0.05 m here, turns along.
  EXPECT_NEAR(value("pose-translation", a, truth, s.context()), 0.2 * seconds, 0.05);
  const Trajectory shifted = answer(s, 0.01, 2.0, {1, 0, 0.2});
  EXPECT_NEAR(value("pose-translation", shifted, truth, s.context()), 0.2 * seconds, 1e-12);
  EXPECT_THAT(mark(metric("pose-rotation"), a, truth, s.context(false)).status, StartsWith("undefined"));
}

TEST(Metrics, ProbesSeeTheirOwnPointAndDirection) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01);
  Trajectory a = truth;
  a.bodies[0].displacement.topRows(3 * (n_volume + n_surface)).setRandom();  // other points
  a.bodies[0].displacement.bottomRows(3).topRows(2).setRandom();             // other directions
  EXPECT_EQ(value("probe-error", a, truth, s.context(true, 1)), 0);
  a.bodies[0].displacement.bottomRows(1) *= 2;
  EXPECT_NEAR(value("probe-error", a, truth, s.context(true, 1)), 1, 1e-14);
}

// Uniaxial stress E e and pure shear sqrt(3) G gamma are the same to von Mises: gamma = E e/(sqrt(3) G).
TEST(Metrics, VonMisesStressIsThatOfTheProbe) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01);
  EXPECT_NEAR(value("probe-von-mises", answer(s, 0.011), truth, s.context(true, 1)), 0.1, 1e-12);
  Trajectory sheared = answer(s, 0.02);  // but for the probe
  auto at_probe = sheared.bodies[0].strain.bottomRows(6);
  at_probe.setZero();
  at_probe.row(4) = 2 * 1.3 / std::sqrt(3.0) * truth.bodies[0].strain.bottomRows(6).row(2);
  EXPECT_NEAR(value("probe-von-mises", sheared, truth, s.context(true, 1)), 0, 1e-12);
  sheared.bodies[0].strain.resize(0, 0);
  EXPECT_TRUE(std::isnan(value("probe-von-mises", sheared, truth, s.context(true, 1))));
}

TEST(Metrics, ShareAboveTheBandIsOfTheTruth) {
  const Setting s = setting();  // the band ends at 5 /s
  const Trajectory slow = answer(s, 1e-3, 0, {0, 0, 0}, 1), fast = answer(s, 1e-3, 0, {0, 0, 0}, 20);
  // Leakage of a Hann window over 0.6 s, whose main lobe ends at 1 + 3.4 /s.
  EXPECT_LT(value("truth-above-band", fast, slow, s.context()), 1e-2);
  EXPECT_GT(value("truth-above-band", slow, fast, s.context()), 0.99);
  EXPECT_GT(distance(metric("truth-above-band"), slow, fast, s.context()), 0.98);
}

TEST(Metrics, NothingToMeasureIsUndefinedNotANumber) {
  const Setting s = setting();
  const Trajectory still = answer(s, 0), a = answer(s, 0.01);
  for (const char* name : {"strain-error", "probe-error", "probe-magnitude", "probe-combined", "truth-above-band"}) {
    const Mark result = mark(metric(name), a, still, s.context(false, 1));
    EXPECT_TRUE(std::isnan(result.value)) << name;
    EXPECT_THAT(result.status, StartsWith("undefined")) << name;
  }
  EXPECT_THAT(mark(metric("displacement-error"), a, still, s.context(false)).status, StartsWith("undefined"));
  Trajectory without = a;
  without.bodies[0].strain.resize(0, 0);
  EXPECT_THAT(mark(metric("strain-error"), without, a, s.context()).status, StartsWith("undefined"));
}

// Modes that cannot move a probe leave it what rounding does.
TEST(Metrics, ASignalOfRoundingIsNone) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01);
  Trajectory quiet = truth;
  quiet.bodies[0].displacement.bottomRows(3).setRandom();
  quiet.bodies[0].displacement.bottomRows(3) *= 1e-13 * truth.bodies[0].displacement.cwiseAbs().maxCoeff();
  const MetricContext context = s.context(false, 1);
  EXPECT_EQ(value("probe-magnitude", quiet, truth, context), -1);
  for (const char* name : {"probe-phase", "probe-combined"})
    EXPECT_THAT(mark(metric(name), quiet, truth, context).status, StartsWith("undefined")) << name;
  EXPECT_THAT(mark(metric("probe-error"), truth, quiet, context).status, StartsWith("undefined"));
}

TEST(Metrics, WhatFailedHasAStatusInsteadOfANumber) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01);
  Trajectory blown = truth, stopped = truth, huge = truth;
  blown.bodies[0].displacement(5, 40) = NAN;
  stopped.status = Status::no_convergence;
  huge.bodies[0].displacement.setConstant(1e200);
  for (const Metric& m : metric_catalogue()) {
    if (m.of_truth_alone) continue;
    EXPECT_TRUE(std::isnan(mark(m, blown, truth, s.context(true, 1)).value)) << m.name;
    EXPECT_EQ(mark(m, blown, truth, s.context(true, 1)).status, "not_finite") << m.name;
    EXPECT_EQ(mark(m, stopped, truth, s.context(true, 1)).status, "no_convergence") << m.name;
    EXPECT_THAT(mark(m, truth, blown, s.context(true, 1)).status, StartsWith("failed: the truth")) << m.name;
    EXPECT_THAT(mark(m, truth, stopped, s.context(true, 1)).status, StartsWith("failed: the truth")) << m.name;
  }
  EXPECT_EQ(mark(metric("displacement-error"), huge, truth, s.context(false)).status, "not_finite");
}

TEST(Metrics, AnswersThatDoNotMatchAreRefused) {
  const Setting s = setting();
  const Trajectory truth = answer(s, 0.01);
  const auto expect_refused = [&](auto&& alter) {
    Trajectory a = truth;
    alter(a);
    EXPECT_THROW(mark(metric("displacement-error"), a, truth, s.context()), std::invalid_argument);
  };
  expect_refused([](Trajectory& a) { a.t(3) += 1e-6; });
  expect_refused([](Trajectory& a) { a.t.conservativeResize(n_t - 1); });
  expect_refused([](Trajectory& a) { a.bodies.clear(); });
  expect_refused([](Trajectory& a) { a.bodies[0].displacement.conservativeResize(30, n_t); });
  expect_refused([](Trajectory& a) { a.bodies[0].strain.conservativeResize(6, n_t); });
  expect_refused([](Trajectory& a) {
    a.t.conservativeResize(n_t - 1);
    a.bodies[0].displacement.conservativeResize(Eigen::NoChange, n_t - 1);
    a.bodies[0].strain.conservativeResize(Eigen::NoChange, n_t - 1);
  });
  const Metric& probe_error = metric("probe-error");
  for (const Index probe : {-1, 0, 2}) {  // none, of another body, beyond the last
    EXPECT_THROW(mark(probe_error, truth, truth, s.context(true, probe)), std::invalid_argument) << probe;
  }
  MetricContext elsewhere = {s.scene, 1, s.points, true};
  EXPECT_THROW(mark(metric("displacement-error"), truth, truth, elsewhere), std::invalid_argument);
}

TEST(Metrics, DistanceIsSymmetricForSmallDifferencesAndUnsigned) {
  const Setting s = setting();
  const Trajectory a = answer(s, 0.01), b = answer(s, 0.010001);
  for (const char* name : {"displacement-error", "strain-error"}) {
    const double ab = distance(metric(name), a, b, s.context(true, 1));
    EXPECT_NEAR(ab, 1e-4, 1e-7);
    EXPECT_NEAR(distance(metric(name), b, a, s.context(true, 1)), ab, 1e-3 * ab);
  }
}

// A hundredth more of everything is that at a probe, too; it is known only to twice that of what moves most.
TEST(Metrics, APartIsKnownNoBetterThanTwiceTheWhole) {
  std::srand(1);  // Eigen's points, whatever tests came before
  const Setting s = setting();
  const Trajectory a = answer(s, 0.01), b = answer(s, 0.0101);
  const MetricContext context = s.context(false, 1);
  const double whole = distance(metric("displacement-error"), a, b, context);
  EXPECT_NEAR(whole, 1e-2, 2e-4);
  for (const char* name : {"probe-error", "probe-magnitude", "probe-phase"}) {
    EXPECT_GE(distance(metric(name), a, b, context), 1.9 * whole) << name;  // it lies farther out than the others
    EXPECT_EQ(distance(metric(name), a, a, context), 0) << name;
  }
  const double strain = mark(metric("truth-strain"), b, b, context).value;
  EXPECT_DOUBLE_EQ(distance(metric("truth-strain"), a, b, context),
                   2 * distance(metric("strain-error"), a, b, context) * strain);
}

}  // namespace
}  // namespace mb
