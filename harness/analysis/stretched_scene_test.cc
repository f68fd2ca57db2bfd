#include "harness/analysis/stretched_scene.h"

#include <gtest/gtest.h>

#include <map>

#include "cases/scene/one_body.h"
#include "harness/analysis/analyses.h"

namespace mb {
namespace {

// A bar of 4 x 1 cells: pulled at both ends, pushed sideways at both.
Scene bar() {
  Scene scene = one_body(Box{{0.4, 0.1, 0.1}}, {1e6, 0.3, 1000, {}}, {2, {4, 1, 1}});
  const auto load = [&](const char* name, double pull, double push) {
    const Pulse pulse{.duration = 0.05};
    scene.loads.push_back(
        {name, pulse, {{"body", {"x-max", {}}, {pull, 0, push}}, {"body", {"x-min", {}}, {-pull, 0, push}}}});
  };
  load("pull", 100, 0);
  load("bend", 0, 1);
  scene.duration = 0.15;
  scene.samples_per_second = 600;
  scene.probes.push_back({"end", "body", {0.2, 0, 0.05}, {0, 0, 1}});
  scene.study.load_tolerance = 1e-5;
  return scene;
}

TEST(StretchedScene, KeepsTheSectionAndTheSizeOfCells) {
  const Scene scene = bar(), ten = stretched(scene, 10), cube = stretched(scene, 1);
  EXPECT_DOUBLE_EQ(slenderness(scene.bodies[0].shape), 4);
  EXPECT_TRUE(std::get<Box>(ten.bodies[0].shape).size.isApprox(Vector3d(1, 0.1, 0.1), 1e-15));
  EXPECT_EQ(ten.bodies[0].resolution.cells, (std::vector<int>{10, 1, 1}));
  EXPECT_EQ(cube.bodies[0].resolution.cells, (std::vector<int>{1, 1, 1}));
  EXPECT_TRUE(ten.probes[0].point.isApprox(Vector3d(0.5, 0, 0.05), 1e-15));
  Scene cylinder = one_body(Cylinder{0.05, 0.2}, {1e6, 0.3, 1000, {}}, {2, {0, 4}});
  Traction disc{"body", {"side", Disc{{0.05, 0, 0.08}, 0.02}}, {1, 0, 0}};
  cylinder.loads.push_back({"push", Step{}, {disc}});
  const Scene longer = stretched(cylinder, 5);
  EXPECT_DOUBLE_EQ(std::get<Cylinder>(longer.bodies[0].shape).length, 0.5);
  EXPECT_EQ(longer.bodies[0].resolution.cells, (std::vector<int>{0, 10}));
  EXPECT_TRUE(longer.loads[0].tractions[0].patch.disc->centre.isApprox(Vector3d(0.05, 0, 0.2), 1e-14));
  EXPECT_DOUBLE_EQ(longer.loads[0].tractions[0].patch.disc->radius, 0.02);
}

TEST(ProportionedScene, ChangesEveryExtentButTheShortestAndPlacesWithThem) {
  const Scene long_one = proportioned(bar(), 200);
  EXPECT_TRUE(std::get<Box>(long_one.bodies[0].shape).size.isApprox(Vector3d(20, 0.1, 0.1), 1e-14));
  EXPECT_TRUE(long_one.probes[0].point.isApprox(Vector3d(10, 0, 0.05), 1e-14));
  EXPECT_EQ(long_one.bodies[0].resolution.cells, bar().bodies[0].resolution.cells);
  Scene plate = one_body(Box{{0.5, 1, 0.01}}, {1e6, 0.3, 1000, {}}, {2, {4, 4, 1}});
  plate.loads.push_back({"press", Step{}, {{"body", {"z-max", Disc{{0.1, 0.2, 0.005}, 0.05}}, {0, 0, -1}}}});
  const Scene block = proportioned(plate, 10);
  EXPECT_TRUE(std::get<Box>(block.bodies[0].shape).size.isApprox(Vector3d(0.05, 0.1, 0.01), 1e-14));
  const Disc disc = *block.loads[0].tractions[0].patch.disc;
  EXPECT_TRUE(disc.centre.isApprox(Vector3d(0.01, 0.02, 0.005), 1e-14));
  EXPECT_DOUBLE_EQ(disc.radius, 0.005);
  const Scene cube = one_body(Box{{0.1, 0.1, 0.1}}, {1e6, 0.3, 1000, {}}, {2, {1, 1, 1}});
  EXPECT_THROW(proportioned(cube, 2), std::invalid_argument);
  EXPECT_THROW(proportioned(plate, 0.5), std::invalid_argument);
}

TEST(StretchedScene, SlowsHistories) {
  const Scene slow = slowed(bar(), 3);
  EXPECT_DOUBLE_EQ(std::get<Pulse>(slow.loads[0].history).duration, 0.15);
  EXPECT_DOUBLE_EQ(slow.duration, 0.45);
  EXPECT_DOUBLE_EQ(slow.samples_per_second, 200);
  for (const History& history : {History(Step{2, 0.1}), History(Ramp{0.3, 2, 0.1}), History(Harmonic{7, 0.4, 2, 0.1}),
                                 History(Chirp{3, 9, 0.5, 2, 0.1}), History(Table{{0.1, 0.2, 0.5}, {1, 3, 2}})})
    for (const double t : {0.0, 0.15, 0.3, 0.45})
      EXPECT_NEAR(value(slowed(history, 2), 2 * t), value(history, t), 1e-14) << history.index() << " " << t;
  EXPECT_THROW(slowed(Expression{"sin(t)"}, 2), std::invalid_argument);
}

TEST(StretchedScene, RefusesWhatHasNoLength) {
  Scene scene = bar();
  scene.bodies[0].shape = Sphere{1};
  EXPECT_THROW(stretched(scene, 2), std::invalid_argument);
  EXPECT_THROW(stretched(bar(), 0), std::invalid_argument);
  scene = bar();
  scene.bodies.push_back(scene.bodies[0]);
  EXPECT_THROW(stretched(scene, 2), std::invalid_argument);
}

struct Key {
  std::string load;
  double ratio, degree;
  auto operator<=>(const Key&) const = default;
};
struct Found {
  double error, at_rest, bar, frequency;
};

std::map<Key, Found> found() {
  const auto scene = std::make_shared<const Scene>(bar());
  const Catalogue catalogue = default_catalogue();
  const TruthSet none;
  const AnalysisContext context{scene, catalogue, none, {}};
  std::map<Key, Found> all;
  const std::vector<Finding> tables = polynomials_over_slenderness(context);
  for (const auto& row : tables.at(0).rows) {
    const auto number = [&](size_t j) { return std::get<double>(row[j]); };
    all[{std::get<std::string>(row[1]), number(2), number(3)}] = {number(5), number(6), number(8), number(9)};
  }
  return all;
}

TEST(Slenderness, PolynomialsDoWhatTheoryOfBarsSays) {
  const auto all = found();
  ASSERT_EQ(all.size(), 6u * 2 * 4);
  for (const double ratio : {1., 2., 5., 10., 20., 50.}) {
    const auto of = [&](const char* load, double degree) { return all.at({load, ratio, degree}); };
    for (const char* load : {"pull", "bend"}) {
      EXPECT_NEAR(of(load, 0).error, 1, 1e-9) << ratio;  // rigid motion has no deformation
      EXPECT_LT(of(load, 2).bar, 1e-2) << ratio;
    }
    EXPECT_NEAR(of("bend", 1).error, 1, 1e-6) << ratio;  // both ends to one side: no linear field takes work of it
    EXPECT_NEAR(of("bend", 1).at_rest, 1, 1e-6) << ratio;
    EXPECT_LT(of("bend", 2).at_rest, 0.6) << ratio;
    // Best in the span, from above, and more of them are no worse.
    EXPECT_GE(of("bend", 3).frequency, 1 - 1e-9) << ratio;
    EXPECT_GE(of("bend", 2).frequency, of("bend", 3).frequency - 1e-9) << ratio;
    EXPECT_LT(of("pull", 1).at_rest, 1e-8) << ratio;  // uniform stress: linear, sections that narrow included
  }
  EXPECT_LT(all.at({"pull", 50, 1}).error, 0.01);  // what a slow pull leaves of the rod's own waves
  // Its static deflection w'' ~ 1 - x^2 (forces at both ends against its inertia) leaves the parabola 0.2274 of itself:
  // w = x^2/4 - x^4/24 against x^2/6, less their means, x in half lengths.
  EXPECT_NEAR(all.at({"bend", 50, 2}).at_rest, 0.2274, 1e-3);  // shear, likewise
  // Of a thin free bar the parabola has omega^2 = 720 EI/(rho A l^4), the first mode 4.7300^4 = 500.56 of it.
  EXPECT_NEAR(all.at({"bend", 50, 2}).frequency, std::sqrt(720 / 500.564), 2e-3);  // shear, 1e-3 at this length
}

}  // namespace
}  // namespace mb
