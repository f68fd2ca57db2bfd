#include "harness/study/mesh_bar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "harness/metrics/metric.h"

namespace mb {
namespace {

// Williams 1952; of 0.3 as tabulated since, 0.711; of 1/2 the root of sin^2(p pi/2) = 1 - p^2.
TEST(MeshBar, KnowsTheOrderAtAClamp) {
  EXPECT_NEAR(order_at_a_clamp(0), 1, 1e-12);
  EXPECT_NEAR(order_at_a_clamp(-0.5), 1, 1e-12);
  EXPECT_NEAR(order_at_a_clamp(0.3), 0.711, 5e-4);
  const double p = order_at_a_clamp(0.5);
  EXPECT_NEAR(p, 0.5946, 5e-5);
  EXPECT_NEAR(std::pow(std::sin(p * pi / 2), 2), 1 - p * p, 1e-12);
}

TEST(MeshBar, IsOfTheBodyWithTheLeastOrder) {
  Body free{"", Box{{1, 1, 1}}, {1e6, 0.45, 1000, {}}, {}, {}, {2, {1, 1, 1}}, {}};
  Body held = free, sliding = free, soft = free, grained = free, plate = free;
  held.supports = {{Support::Kind::fixed, {}}};
  held.material.poissons_ratio = 0.3;
  sliding.supports = {{Support::Kind::sliding, {}}};
  soft.material.inclusions = {{{0, 0, 0}, {1, 1, 1}, 1e-3}};
  grained.supports = {{Support::Kind::driven, {}}};
  grained.material.orthotropy = Orthotropy{};
  plate.theory = Theory::kirchhoff;
  const auto order = [](std::vector<Body> bodies) {
    Scene scene{};
    scene.bodies = std::move(bodies);
    return order_of_modes(scene);
  };
  EXPECT_EQ(order({free, sliding, plate}), 1);
  EXPECT_EQ(order({free, held}), order_at_a_clamp(0.3));
  EXPECT_EQ(order({held, soft}), order_at_a_soft_part);
  EXPECT_EQ(order({grained}), order_at_a_clamp(0.5));
  Scene sticking{};
  sticking.bodies = {free}, sticking.bodies[0].name = "foot";
  sticking.contacts = {{.body = "foot", .obstacle = "floor", .stiffness = 0}};
  EXPECT_EQ(order_of_modes(sticking), 1);
  sticking.contacts[0].friction = 0.3;
  EXPECT_EQ(order_of_modes(sticking), order_at_a_clamp(0.45));
}

TEST(MeshBar, IsThatOfFrontsWhereALoadJumpsAndNoStiffnessDampingSmoothsThem) {
  Scene scene{};
  scene.duration = 1;
  scene.bodies = {{"rod", Box{{1, 1, 1}}, {1e6, 0.3, 1000, {}}, {}, {}, {2, {1, 1, 1}}, {}}};
  scene.loads = {{"push", Pulse{0.5}, {{"rod", {}, {0, 0, 1}}}}};
  scene.truth.coarser = {3, {1, 1, 1}};
  EXPECT_EQ(orders_of_motion(scene).local.in_size, 1);
  scene.loads[0].history = Step{};
  const auto [local, mean] = orders_of_motion(scene);
  EXPECT_EQ(local.in_size, 0.4);  // of the body's own degree 2: n/(2n + 1)
  EXPECT_EQ(local.in_degree, 0.4);
  EXPECT_DOUBLE_EQ(mean.in_size, 1.2);
  EXPECT_DOUBLE_EQ(mean.in_degree, 1.2);
  EXPECT_EQ(order_of_modes(scene), 1);
  scene.bodies[0].supports = {{Support::Kind::fixed, {}}};
  EXPECT_EQ(orders_of_motion(scene).local.in_size, 0.4);
  scene.bodies[0].damping.beta = 1e-4;
  EXPECT_EQ(orders_of_motion(scene).local.in_size, order_at_a_clamp(0.3));
  EXPECT_EQ(orders_of_motion(scene).mean.in_degree, 4 * order_at_a_clamp(0.3));
}

TEST(MeshBar, IsAQuarterMoreThanWhatTwoMeshesTell) {
  const double p = 0.7;
  EXPECT_NEAR(bar_per_distance({2, {1, 1, 12}}, {2, {1, 1, 6}}, 1), 1.25, 1e-12);
  EXPECT_NEAR(bar_per_distance({2, {1, 1, 12}}, {2, {1, 1, 6}}, p), 1.25 / (std::pow(2, p) - 1), 1e-12);
  EXPECT_NEAR(bar_per_distance({4, {1, 1, 6}}, {3, {1, 1, 6}}, p), 1.25 / (std::pow(4. / 3, 2 * p) - 1), 1e-12);
  EXPECT_NEAR(bar_per_distance({4, {1, 1, 6}}, {3, {1, 1, 6}}, 2 * p), 1.25, 1e-12);
  EXPECT_NEAR(bar_per_distance({3, {2}, 3}, {3, {2}, 2}, p), bar_per_distance({3, {2}}, {3, {1}}, p), 1e-12);
  EXPECT_NEAR(bar_per_distance({2, {1, 4}}, {2, {0, 4}}, p), bar_per_distance({2, {2, 4}}, {2, {1, 4}}, p), 1e-12);
}

TEST(MeshBar, IsThatOfTheDirectionAndTheBodyThatChangeLeast) {
  const Resolution board{2, {24, 2, 1}, 3}, wider{2, {16, 2, 1}, 2};
  EXPECT_DOUBLE_EQ(fall_of_errors(board, wider, 1), 1.5);
  EXPECT_DOUBLE_EQ(fall_of_errors({2, {3, 3, 2}}, {2, {2, 2, 1}}, 1), 1.5);
  EXPECT_DOUBLE_EQ(fall_of_errors({2, {1, 1, 8}}, {2, {1, 1, 4}}, 1), 2);        // of what is off across they are mute
  EXPECT_DOUBLE_EQ(fall_of_errors({4, {1, 1, 8}}, {3, {1, 1, 4}}, 1), 16. / 9);  // and here the degree tells of it
  Resolution both{2, {2}, 3}, before{2, {2}, 2};
  EXPECT_DOUBLE_EQ(fall_of_errors(both, before, 1), 2);
  both.others = {board}, before.others = {wider};
  EXPECT_DOUBLE_EQ(fall_of_errors(both, before, 1), 1.5);
  EXPECT_DOUBLE_EQ(bar_per_distance(both, before, 1), 1.25 / 0.5);
}

TEST(MeshBar, IsNoneWhereTwoMeshesTellNothing) {
  EXPECT_TRUE(std::isinf(bar_per_distance({2, {3}}, {2, {3}}, 1)));
  EXPECT_TRUE(std::isinf(bar_per_distance({1, {3}}, {2, {3}}, 1)));
  EXPECT_TRUE(std::isinf(bar_per_distance({2, {4, 2}}, {2, {2, 3}}, 1)));
}

TEST(MeshBar, TellsMetricsOfStrainAndOfLargestValues) {
  const std::set<std::string> least{"strain-error", "truth-strain", "probe-von-mises", "surface-deviation",
                                    "truth-rotation"};
  for (const Metric& each : metric_catalogue())
    EXPECT_EQ(is_of_least_order(each), least.contains(each.name)) << each.name;
}

}  // namespace
}  // namespace mb
