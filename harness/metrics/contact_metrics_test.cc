#include "harness/metrics/contact_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "harness/metrics/one_touch_test.h"

namespace mb {
namespace {

using ::testing::StartsWith;

constexpr double infinity = std::numeric_limits<double>::infinity();

using namespace one_touch;

TEST(ContactMetrics, AreInTheCatalogueForContactAlone) {
  const std::set<std::string> alone{"touches",         "energy-gain",    "energy-defect",
                                    "momentum-defect", "momentum-drift", "angular-drift"};
  ASSERT_EQ(contact_metrics().size(), 12u);
  for (const Metric& of : contact_metrics()) {
    EXPECT_TRUE(of.contact_only);
    EXPECT_TRUE(metric(of.name).contact_only);
    EXPECT_EQ(of.of_answer_alone, alone.contains(of.name)) << of.name;
  }
}

TEST(ContactMetrics, OfFirstTouchesByHand) {
  const Setting s = setting();
  const Trajectory truth = answer(s);
  Trajectory a = truth;
  contact(a).touches = {{0.12, 0.28, 99, 0.2, {0, 3, 14}}, {0.4, 0.41, 1e6, 0.4, {0, 0, 1e6}}};
  EXPECT_NEAR(value("first-touch", a, truth, s.context()), 0.02, 1e-15);
  EXPECT_NEAR(value("contact-duration", a, truth, s.context()), 0.04 / 0.2, 1e-14);
  EXPECT_NEAR(value("peak-force", a, truth, s.context()), 0.1, 1e-15);
  EXPECT_NEAR(value("impulse", a, truth, s.context()), 5.0 / 18, 1e-15);  // |(0, 3, -4)| / 18
  // v at 0.12 s: -3.2; after: -3.2 + (0, 3, 14)/6 - 1.6 along j = (0, 3, 14)/sqrt(205).
  const double e = -(3.0 * 0.5 + 14 * (-3.2 + 14.0 / 6 - 1.6)) / (14 * -3.2);
  // Of the truth: v -3, after -3 + 3 - 2 = -2: e = -(-2)/-3.
  EXPECT_NEAR(value("restitution", a, truth, s.context()), std::abs(e + 2.0 / 3), 1e-14);
  EXPECT_NEAR(restitution(s.scene, s.scene.bodies[0], truth.bodies[0].contact.touches[0]), -2.0 / 3, 1e-15);
  for (const char* name : {"first-touch", "contact-duration", "peak-force", "impulse", "restitution", "force-error"})
    EXPECT_EQ(value(name, truth, truth, s.context()), 0) << name;
}

// The truth touches once, from 1 to 3 s; what begins at 4 s or later is another contact.
TEST(ContactMetrics, TouchesThatBelongTogetherAreOneContact) {
  const std::vector<Touch> truth{{1, 3, 9, 2, {0, 0, 8}}, {4, 5, 99, 4.5, {0, 0, 99}}};
  const Touch a{1.1, 1.3, 7, 1.2, {1, 0, 2}}, b{2.9, 2.95, 5, 2.92, {0, 2, 3}}, c{3.999, 6, 8, 5, {0, 0, 4}};
  const Touch later{6.5, 7, 1e6, 6.6, {0, 0, 1e6}};
  const auto of = first_contact({a, b, c, later}, truth);
  ASSERT_TRUE(of);
  EXPECT_EQ(of->n_touches, 3);
  EXPECT_EQ(of->whole.start, 1.1);
  EXPECT_EQ(of->whole.end, 6);
  EXPECT_EQ(of->whole.peak_force, 8);
  EXPECT_EQ(of->whole.peak_time, 5);
  EXPECT_EQ(of->whole.impulse, Vector3d(1, 2, 9));
  EXPECT_EQ(first_contact({a, {4, 5, 1, 4, {0, 0, 1}}}, truth)->n_touches, 1);  // not before 3 + (3 - 1)/2
  EXPECT_EQ(first_contact({a, b, later}, truth)->whole.peak_force, 7);          // that of the first
  EXPECT_EQ(first_contact({later}, truth)->whole.start, 6.5);                   // late, but its first
  EXPECT_EQ(first_contact(truth, truth)->n_touches, 1);
  EXPECT_EQ(first_contact(truth, truth)->whole.end, 3);
  EXPECT_EQ(first_contact({a, {2, infinity, 1, 3, {0, 0, 1}}}, truth)->whole.end, infinity);
  // A truth that rests in the end: all is one contact.
  EXPECT_EQ(first_contact({a, b, c, later}, {{1, infinity, 9, 2, {0, 0, 8}}})->n_touches, 4);
  EXPECT_FALSE(first_contact({}, truth));
  EXPECT_FALSE(first_contact({a}, {}));
}

// A truth that chatters is measured by the same rule: its own second touch belongs to it.
TEST(ContactMetrics, ChatterIsMarkedAsAWhole) {
  const Setting s = setting();
  const Trajectory truth = answer(s);
  Trajectory a = truth;
  // Cut in three, impulses 6 + 3 + 9.
  contact(a).touches = {
      {0.1, 0.14, 80, 0.12, {0, 0, 6}}, {0.17, 0.2, 90, 0.2, {0, 0, 3}}, {0.25, 0.3, 70, 0.27, {0, 0, 9}}};
  for (const char* name : {"first-touch", "contact-duration", "peak-force", "impulse", "restitution"})
    EXPECT_NEAR(value(name, a, truth, s.context()), 0, 1e-15) << name;
  EXPECT_EQ(value("touches", a, truth, s.context()), 3);
  EXPECT_EQ(value("touches", truth, truth, s.context()), 1);
  contact(a).touches.pop_back();
  EXPECT_NEAR(value("impulse", a, truth, s.context()), 0.5, 1e-15);
  EXPECT_NEAR(value("contact-duration", a, truth, s.context()), 0.5, 1e-14);
  Trajectory chattering = truth;  // its first touch: 0.1 to 0.2 s; what begins before 0.25 s belongs to it
  contact(chattering).touches = {{0.1, 0.2, 60, 0.15, {0, 0, 8}}, {0.24, 0.3, 90, 0.26, {0, 0, 10}}};
  EXPECT_NEAR(value("impulse", truth, chattering, s.context()), 0, 1e-15);
  EXPECT_NEAR(value("contact-duration", truth, chattering, s.context()), 0, 1e-15);
  Trajectory none = truth;
  contact(none).touches.clear();
  EXPECT_EQ(value("touches", none, truth, s.context()), 0);
  EXPECT_THAT(marked("touches", truth, none, s.context()).status, StartsWith("undefined"));
}

TEST(ContactMetrics, ForceErrorByHand) {
  const Setting s = setting();
  Trajectory a = answer(s), truth = answer(s);
  contact(truth).force.row(2) << 2, 0, 90, 0, 0;
  contact(a).force.row(2) << 0, 0, 90, 4, 0;
  contact(a).force(0, 4) = 6;
  // Trapezoidal: halves at the ends. (4/2 + 16 + 36/2) / (4/2 + 8100).
  EXPECT_NEAR(value("force-error", a, truth, s.context()), std::sqrt(36.0 / 8102), 1e-14);
}

TEST(ContactMetrics, EnergyGainByHand) {
  const Setting s = setting();
  Trajectory a = answer(s);
  EXPECT_EQ(value("energy-gain", a, a, s.context()), 0);  // 100, 100, 100, 100, 100 with the losses
  a.bodies[0].energy[3] = 98.5;                           // 1.5 J more by 6 (2 + 10 0.1)^2 / 2 = 27 J
  EXPECT_NEAR(value("energy-gain", a, a, s.context()), 1.5 / 27, 1e-14);
  contact(a).stored[2] = 54;  // more is in play
  EXPECT_NEAR(value("energy-gain", a, a, s.context()), 1.5 / 54, 1e-14);
  contact(a).touches.clear();  // 6 2^2 / 2 = 12
  contact(a).stored[2] = 4;
  EXPECT_NEAR(value("energy-gain", a, a, s.context()), 1.5 / 12, 1e-14);
  a.bodies[0].energy.setConstant(50);  // only the losses grow: that, too, is a gain
  EXPECT_NEAR(value("energy-gain", a, a, s.context()), 3.0 / 12, 1e-14);
  a.bodies[0].energy = VectorXd{{50, 40, 30, 20, 10}};
  EXPECT_EQ(value("energy-gain", a, a, s.context()), 0);
}

TEST(ContactMetrics, EnergyFedByHand) {
  Setting s = setting();
  Trajectory a = answer(s), truth = a;
  EXPECT_EQ(energy_fed(a, truth, s.context()), 0);
  a.bodies[0].energy.setConstant(100);  // what contacts lose without its going down is no growth
  EXPECT_EQ(energy_fed(a, truth, s.context()), 0);
  a.bodies[0].energy[3] = 113.5;  // by 27 J, see above
  EXPECT_NEAR(energy_fed(a, truth, s.context()), 0.5, 1e-14);
  contact(a).stored[2] = 540;  // by what ought to be in play, not by what is
  EXPECT_NEAR(energy_fed(a, truth, s.context()), 0.5, 1e-14);
  contact(truth).stored[2] = 54;
  EXPECT_NEAR(energy_fed(a, truth, s.context()), 0.25, 1e-14);
  Setting loaded = s, driven = s;
  loaded.scene.loads = {{"push", Step{}, {}}};
  driven.scene.bodies[0].supports = {{Support::Kind::driven, {}, Drive{}}};
  for (const Setting& other : {loaded, driven}) EXPECT_TRUE(std::isnan(energy_fed(a, truth, other.context())));
  a.bodies[0].energy.resize(0);
  EXPECT_TRUE(std::isnan(energy_fed(a, truth, s.context())));
}

TEST(ContactMetrics, EnergyDefectByHand) {
  Setting s = setting();
  Trajectory a = answer(s);
  EXPECT_EQ(value("energy-defect", a, a, s.context()), 0);
  a.bodies[0].energy[2] = 200;  // it is the end that counts
  EXPECT_EQ(value("energy-defect", a, a, s.context()), 0);
  for (const double more : {1.5, -1.5}) {  // gained or lost: by 27 J, see above
    a.bodies[0].energy[4] = 97 + more;
    EXPECT_NEAR(value("energy-defect", a, a, s.context()), 1.5 / 27, 1e-14);
  }
  Body& body = s.scene.bodies[0];
  const auto undefined = [&] {
    EXPECT_THAT(marked("energy-defect", a, a, s.context()).status, StartsWith("undefined"));
  };
  body.damping = {0.1, 0};
  undefined();
  body.damping = {0, 1e-6};
  undefined();
  body.damping = {};
  body.damping_ratios = {0, 0.01};
  undefined();
  body.damping_ratios = {0, 0};
  EXPECT_NEAR(value("energy-defect", a, a, s.context()), 1.5 / 27, 1e-14);
  s.scene.loads = {{"push", Step{}, {}}};
  undefined();
}

TEST(ContactMetrics, MomentumDefectByHand) {
  const Setting s = setting();
  Trajectory a = answer(s);
  // int J dt / m by trapezoids: 0.1 (9 + 18 + 18/2) / 6 = 0.6 m; without a defect the centre is at -0.8 - 0.8 + 0.6.
  const auto put = [&](const Vector3d& c) {
    for (Index p = 0; p < s.points.size(); ++p) a.bodies[0].displacement.col(4).segment<3>(3 * p) = c;
  };
  put({0, 0, -1});
  EXPECT_NEAR(value("momentum-defect", a, a, s.context()), 0, 1e-14);
  put({0.03, 0, -1.04});
  EXPECT_NEAR(value("momentum-defect", a, a, s.context()), 0.05 / 0.6, 1e-13);
  // Turned about its centre it is where it was.
  put({0, 0, -1});
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2).normalized()).toRotationMatrix();
  const Matrix3Xd X = s.points.all();
  a.bodies[0].displacement.col(4) += ((R - Eigen::Matrix3d::Identity()) * X).reshaped();
  EXPECT_NEAR(value("momentum-defect", a, a, s.context()), 0, 1e-13);
}

TEST(ContactMetrics, AreUndefinedWhereNothingIsToBeMeasured) {
  const Setting s = setting();
  const Trajectory truth = answer(s);
  Trajectory none = truth;
  contact(none).touches.clear();
  for (const char* name : {"first-touch", "contact-duration", "peak-force", "impulse", "restitution"}) {
    EXPECT_THAT(marked(name, none, truth, s.context()).status, StartsWith("undefined")) << name;
    EXPECT_THAT(marked(name, truth, none, s.context()).status, StartsWith("undefined")) << name;
  }
  for (const char* name : {"restitution", "momentum-defect"})
    EXPECT_THAT(marked(name, truth, truth, s.context(false)).status, StartsWith("undefined")) << name;
  Trajectory empty = truth;  // surfaces meet, no more: 0/0 is nothing
  contact(empty).touches = {{0.1, 0.1, 0, 0.1, Vector3d::Zero()}};
  for (const char* name : {"contact-duration", "peak-force", "impulse", "restitution"})
    EXPECT_THAT(marked(name, truth, empty, s.context()).status, StartsWith("undefined")) << name;
  Trajectory still = truth;
  contact(still).force.setZero();
  EXPECT_THAT(marked("force-error", truth, still, s.context()).status, StartsWith("undefined"));
  contact(still).impulse.setZero();
  EXPECT_THAT(marked("momentum-defect", still, truth, s.context()).status, StartsWith("undefined"));
  Trajectory unrecorded = truth;
  unrecorded.bodies[0].energy.resize(0);
  for (const char* name : {"energy-gain", "energy-defect"})
    EXPECT_THAT(marked(name, unrecorded, truth, s.context()).status, StartsWith("undefined")) << name;
  Trajectory broken = truth;
  broken.bodies[0].energy[2] = std::nan("");
  for (const char* name : {"energy-gain", "energy-defect"})
    EXPECT_THAT(marked(name, broken, truth, s.context()).status, StartsWith("undefined")) << name;
  Trajectory unplaced = truth;  // of contact alone
  unplaced.bodies[0].displacement.resize(3 * s.points.size(), 0);
  EXPECT_THAT(marked("momentum-defect", unplaced, truth, s.context()).status, StartsWith("undefined"));
  EXPECT_EQ(value("energy-gain", unplaced, truth, s.context()), 0);
  contact(unrecorded).force.resize(3, 0);
  contact(unrecorded).impulse.resize(3, 0);
  EXPECT_THAT(marked("force-error", unrecorded, truth, s.context()).status, StartsWith("undefined"));
  EXPECT_THAT(marked("momentum-defect", unrecorded, truth, s.context()).status, StartsWith("undefined"));
}

// No duration to be marked, not even against another one that lasts.
TEST(ContactMetrics, ATouchThatLastsHasNoEndAsYet) {
  const Setting s = setting();
  const Trajectory truth = answer(s);
  Trajectory lasting = truth;
  contact(lasting).touches[0].end = infinity;
  for (const char* name : {"contact-duration", "restitution"})
    for (const auto& [one, other] :
         {std::pair<const Trajectory*, const Trajectory*>{&lasting, &truth}, {&truth, &lasting}, {&lasting, &lasting}})
      EXPECT_THAT(marked(name, *one, *other, s.context()).status, StartsWith("undefined")) << name;
  EXPECT_EQ(value("peak-force", lasting, truth, s.context()), 0);
}

// A ball of 2 kg at 5 m/s on a body that is held: it feels the opposite of the body's impulse.
TEST(ContactMetrics, OfWhatStrikesABody) {
  Setting s = setting();
  s.scene.bodies[0].twist = {};
  s.scene.obstacles = {{"ball", {Sphere{0.01}, 0, {{0, 0, 0.16}, {1, 0, 0, 0}}}, Striker{2, 5, 1e9, 0.3}}};
  s.scene.contacts = {{.body = s.scene.bodies[0].name, .obstacle = "ball", .stiffness = 0}};
  Trajectory truth = answer(s), a = truth;
  contact(truth).touches = {{0, 0.1, 90, 0.05, {0, 0, -18}}};
  contact(a).touches = {{0, 0.1, 90, 0.05, {0, 0, -16}}};
  EXPECT_NEAR(restitution(s.scene, s.scene.bodies[0], truth.bodies[0].contact.touches[0]), 0.8, 1e-15);
  EXPECT_NEAR(value("restitution", a, truth, s.context(false)), 0.2, 1e-15);
  contact(a).touches[0].end = infinity;  // as yet it goes on
  EXPECT_TRUE(std::isnan(restitution(s.scene, s.scene.bodies[0], contact(a).touches[0])));
  a.bodies[0].energy[4] = 97 + 5;  // by 2 5^2 / 2 = 25 J
  EXPECT_NEAR(value("energy-gain", a, a, s.context(false)), 0.2, 1e-15);
}

}  // namespace
}  // namespace mb
