#include "harness/metrics/finite_metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"

namespace mb {
namespace {

// Five times in 0.4 s, pushed until 0.15 s; energies by hand.
struct Pushed {
  Scene scene = one_body(Box{{0.1, 0.2, 0.3}}, {1e6, 0.3, 1000, {}}, {1, {1, 1, 1}});
  Trajectory answer{VectorXd::LinSpaced(5, 0, 0.4), {}, {}, Status::ok};

  Pushed() {
    scene.duration = 0.4;
    scene.loads = {{"push", Pulse{0.15}, {}}};
    answer.bodies.resize(1);
    answer.bodies[0].energy = VectorXd{{0, 5, 4, 4.5, 3}};
  }
  double gain() const { return free_gain(answer, scene); }
};

TEST(FreeGain, IsWhatRisesOnceNothingPushes) {
  Pushed s;
  EXPECT_NEAR(s.gain(), 0.5 / 5, 1e-15) << "from 4 at 0.2 s to 4.5, by 5 before";
  s.answer.bodies[0].energy = VectorXd{{0, 5, 4, 3, 2}};
  EXPECT_EQ(s.gain(), 0);
  s.scene.loads.clear();  // from the start
  EXPECT_TRUE(std::isnan(s.gain())) << "nothing was there";
  s.answer.bodies[0].energy = VectorXd{{2, 1, 3, 2, 1}};
  EXPECT_NEAR(s.gain(), 0.5, 1e-15);
}

TEST(FreeGain, IsNoNumberWhereSomethingElseDoesWorkOrNothingIsKnown) {
  const auto gain_of = [](auto&& alter) {
    Pushed s;
    alter(s);
    return s.gain();
  };
  EXPECT_TRUE(std::isnan(gain_of([](Pushed& s) { s.scene.gravity = {0, 0, -9.81}; })));
  EXPECT_TRUE(std::isnan(gain_of([](Pushed& s) { s.scene.loads = {{"push", Step{}, {}}}; })));
  EXPECT_TRUE(std::isnan(gain_of([](Pushed& s) { s.scene.loads = {{"push", Pulse{0.39}, {}}}; }))) << "one time";
  EXPECT_TRUE(std::isnan(gain_of([](Pushed& s) {
    s.scene.bodies[0].supports = {{Support::Kind::driven, {}, Drive{}}};
  })));
  EXPECT_TRUE(std::isnan(gain_of([](Pushed& s) { s.scene.contacts.emplace_back(); })));
  EXPECT_TRUE(std::isnan(gain_of([](Pushed& s) { s.answer.bodies[0].energy.resize(0); })));
  EXPECT_TRUE(std::isnan(gain_of([](Pushed& s) { s.answer.bodies[0].energy[3] = NAN; })));
}

}  // namespace
}  // namespace mb
