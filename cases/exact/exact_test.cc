// Which scenes the closed forms hold for, and what they say of those they do not.
#include "cases/exact/exact.h"

#include <gtest/gtest.h>

#include <regex>
#include <stdexcept>

#include "cases/exact/exact_test_problems.h"
#include "cases/exact/exact_test_scenes.h"

namespace mb {
namespace {

// What no closed form takes.
const std::vector<Wrong> common = {
    {[](Scene& s) { s.bodies.push_back(s.bodies[0]); }, "needs one body, there are 2"},
    {[](Scene& s) { s.bodies.clear(); }, "needs one body, there are 0"},
    {[](Scene& s) { s.loads.clear(); }, "needs one load, there are 0"},
    {[](Scene& s) { s.loads[0].tractions.push_back(s.loads[0].tractions[0]); }, "needs one traction, the load has 2"},
    {[](Scene& s) {
       s.loads[0].tractions[0].patch.disc = {Vector3d::Zero(), 0.1};
     },
     "covers a disc"},
    {[](Scene& s) { s.bodies[0].damping.beta = 1e-9; }, "damped"},
    {[](Scene& s) { s.bodies[0].damping.alpha = 1; }, "damped"},
    {[](Scene& s) {
       s.bodies[0].damping_ratios = {0, 0.01};
     },
     "damped"},
    {[](Scene& s) { s.bodies[0].material.orthotropy = Orthotropy{}; }, "not isotropic"},
    {[](Scene& s) {
       s.bodies[0].shape = Cylinder{0.1, 1};
     },
     "the body is not a"},
    {[](Scene& s) { s.loads[0].history = Ramp{1}; }, "the history is not a"},
};

TEST(ExactSolutionTest, NamesWhatDoesNotFitARod) {
  const Scene held = rod_scene("z-max", {support(Support::Kind::fixed, "z-min")});
  expect_problems("rod-step", held, common);
  const auto add = [](Support::Kind kind, const char* face) {
    return [=](Scene& s) { s.bodies[0].supports.push_back(support(kind, face)); };
  };
  using K = Support::Kind;
  expect_problems("rod-step", held,
                  {{[](Scene& s) { s.bodies[0].material.poissons_ratio = 0.3; }, "Poisson's ratio is 0.3, not 0"},
                   {[](Scene& s) { s.loads[0].tractions[0].traction[0] = 1; }, "the traction is not along z"},
                   {[](Scene& s) { s.loads[0].tractions[0].patch.face = "x-max"; }, "the load acts on x-max"},
                   {[](Scene& s) {
                      s.bodies[0].supports[0].patch.disc = {Vector3d::Zero(), 0.1};
                    },
                    "support of z-min"},
                   {add(K::fixed, "z-max"), "support of z-max"},
                   {add(K::fixed, "x-min"), "support of x-min"},
                   {add(K::mean, "z-min"), "support of z-min"},
                   {add(K::driven, "z-min"), "support of z-min"},
                   {add(K::diaphragm, "y-max"), "support of y-max"}});
  for (const Scene& right :
       {rod_scene("z-min", {}), rod_scene("z-min", {support(K::sliding, "z-max"), support(K::sliding, "x-min")})})
    EXPECT_EQ(exact_solution("rod-step").problem(right), "");
}

TEST(ExactSolutionTest, NamesWhatDoesNotFitASphere) {
  const Scene right = sphere_scene();
  expect_problems("sphere-radial-pulse", right, common);
  expect_problems(
      "sphere-radial-pulse", right,
      {{[](Scene& s) { s.bodies[0].supports.push_back(support(Support::Kind::mean, "surface")); }, "not free"},
       {[](Scene& s) { s.loads[0].tractions[0].traction[2] = 1; }, "not a pressure alone"},
       {[](Scene& s) { std::get<Pulse>(s.loads[0].history).start = -1e-5; }, "before the motion"},
       {[](Scene& s) { std::get<Pulse>(s.loads[0].history).duration = 1e-8; }, "too short"}});
}

TEST(ExactSolutionTest, NamesEveryReason) {
  Scene scene = sphere_scene();
  scene.bodies[0].damping.alpha = 1;
  scene.loads.clear();
  EXPECT_EQ(exact_solution("sphere-radial-pulse").problem(scene), "the body is damped; needs one load, there are 0");
}

TEST(ExactSolutionTest, AreFoundByName) {
  EXPECT_GE(exact_solutions().size(), 2u);
  for (const ExactSolution& solution : exact_solutions()) {
    EXPECT_EQ(exact_solution(solution.name).doc, solution.doc);
    EXPECT_TRUE(std::regex_match(solution.name, std::regex("[a-z0-9-]+")));
    EXPECT_FALSE(solution.source.empty());
    EXPECT_GT(solution.error_bar, 0);
  }
  for (const char* wrong : {"", "rod", "rod_step"}) EXPECT_THROW(exact_solution(wrong), std::out_of_range);
}

}  // namespace
}  // namespace mb
