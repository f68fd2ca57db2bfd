#include <gmock/gmock.h>

#include <cmath>

#include "harness/analysis/context_test.h"
#include "harness/study/mesh_bar.h"

namespace mb {
namespace {

// A cube of 0.1 m, E = 70 GPa, nu = 0.3, rho = 2700 kg/m^3; frequencies of cases/free-cube.toml.
Scene cube(std::array<Resolution, 3> meshes, std::vector<double> hertz) {
  Scene scene;
  scene.name = "cube";
  Body body;
  body.name = "cube";
  body.shape = Box{{0.1, 0.1, 0.1}};
  body.material = {70e9, 0.3, 2700};
  body.resolution = meshes[1];
  scene.bodies.push_back(body);
  scene.truth.coarser = meshes[0];
  scene.truth.finer = meshes[2];
  scene.reference_frequencies = {std::move(hertz), 2e-8};
  return scene;
}

Finding frequencies_of(const Scene& scene) { return test::analysed("frequencies", scene).front(); }

double number(const Finding& found, size_t row, const std::string& column) {
  for (size_t i = 0; i < found.columns.size(); ++i)
    if (found.columns[i].name == column) return std::get<double>(found.rows.at(row)[i]);
  throw std::out_of_range("no column " + column);
}

TEST(NaturalFrequencies, FallTowardsPublishedOnesAtTheOrderOfTheElement) {
  const Finding found = frequencies_of(cube({{{1, {2, 2, 2}}, {1, {4, 4, 4}}, {1, {8, 8, 8}}}},
                                            {14353.75688, 14353.75688, 19328.87687, 19328.87687, 19328.87687}));
  ASSERT_EQ(found.rows.size(), 5u);
  for (size_t i = 0; i < 5; ++i) {
    const double coarse = number(found, i, "error Q1 2x2x2"), own = number(found, i, "error Q1 4x4x4"),
                 fine = number(found, i, "error Q1 8x8x8");
    EXPECT_GT(fine, 0);
    EXPECT_GT(own, 3 * fine);  // 4 in the limit
    EXPECT_GT(coarse, own);
    EXPECT_EQ(number(found, i, "error"), own);
    EXPECT_NEAR(number(found, i, "frequency"), number(found, i, "reference") * (1 + own), 1e-6);
    EXPECT_DOUBLE_EQ(number(found, i, "order"), std::log2(own / fine));  // of the finest two, not the outer two
  }
}

// The index knows nothing of the published frequency and still bounds the error against it.
TEST(NaturalFrequencies, LieWithinTheBandThatTheMeshesAloneGive) {
  const std::vector<double> lowest{14353.75688, 14353.75688, 19328.87687};
  const std::array<Resolution, 3> three{{{1, {2, 2, 2}}, {1, {4, 4, 4}}, {1, {8, 8, 8}}}};
  const std::array<Resolution, 3> two{{{1, {6, 6, 6}}, {1, {7, 7, 7}}, {1, {8, 8, 8}}}};
  for (const auto& [meshes, factor] : {std::pair(three, 1.25), std::pair(two, 3.0)}) {
    const Finding found = frequencies_of(cube(meshes, lowest));
    for (size_t i = 0; i < lowest.size(); ++i) {
      const double error = number(found, i, "error Q1 8x8x8"), index = number(found, i, "GCI");
      EXPECT_GT(index, error) << i << " " << factor;
      if (i < 2 || factor == 3) {  // eight cells show the third mode at order 2, two do not
        EXPECT_NEAR(index, factor * error, 0.25 * factor * error) << i << " " << factor;
      }
    }
  }
  const Finding alone = frequencies_of(cube({{{1, {3, 3, 3}}, {2, {3, 3, 3}}, {3, {2, 2, 2}}}}, {14353.75688}));
  EXPECT_TRUE(std::isnan(number(alone, 0, "GCI")));
  EXPECT_NE(alone.note.find("no two meshes"), std::string::npos);
}

// At a clamp stress is singular: what a pair of meshes leaves open is told by the order there, 1.42, not by 2 of Q1.
TEST(NaturalFrequencies, OfHeldBodiesHaveTheWiderBandOfAClamp) {
  Scene held = cube({{{1, {3, 3, 3}}, {1, {4, 4, 4}}, {1, {5, 5, 5}}}}, {8000});
  const auto is_of_order = [&](double order) {
    const Finding found = frequencies_of(held);
    const double fine = 1 + number(found, 0, "error Q1 5x5x5"), own = 1 + number(found, 0, "error Q1 4x4x4");
    EXPECT_NEAR(number(found, 0, "GCI"), 3 * (own - fine) / fine / (std::pow(1.25, order) - 1), 1e-9);
  };
  is_of_order(2);
  held.bodies[0].supports.push_back({Support::Kind::fixed, {"z-min", {}}});
  is_of_order(2 * order_at_a_clamp(0.3));
}

TEST(NaturalFrequencies, TellNoOrderWhereNoneCanBeSeen) {
  const std::vector<double> lowest{14353.75688};
  const auto order = [&](std::array<Resolution, 3> meshes, const std::vector<double>& hertz) {
    return number(frequencies_of(cube(meshes, hertz)), 0, "order");
  };
  EXPECT_TRUE(std::isnan(order({{{1, {3, 3, 3}}, {2, {3, 3, 3}}, {3, {2, 2, 2}}}}, lowest)));   // three degrees
  EXPECT_TRUE(std::isnan(order({{{1, {2, 2, 3}}, {1, {2, 3, 2}}, {1, {3, 3, 3}}}}, lowest)));   // three shapes of cell
  EXPECT_TRUE(std::isnan(order({{{2, {1, 1, 1}}, {2, {2, 2, 2}}, {2, {3, 3, 3}}}}, {15000})));  // errors change sign
}

TEST(NaturalFrequencies, RefuseWhatCannotBeCompared) {
  const std::array<Resolution, 3> meshes{{{1, {1, 1, 1}}, {1, {2, 2, 2}}, {1, {3, 3, 3}}}};
  EXPECT_THROW(frequencies_of(cube(meshes, {})), std::invalid_argument);
  EXPECT_THROW(frequencies_of(cube(meshes, std::vector<double>(60, 1e4))),
               std::invalid_argument);  // 24 DoF, 18 elastic
}

}  // namespace
}  // namespace mb
