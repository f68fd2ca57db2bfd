// Modes on deal.II meshes against independent targets (cases/exact/tables).
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "cases/scene/one_body.h"
#include "modal/bases/eigenmodes.h"
#include "reference/full_model.h"

namespace mb {
namespace {

// Rows of a table without its comments and header.
std::vector<std::vector<std::string>> rows(const std::string& name) {
  std::ifstream file(std::string(MB_SOURCE_DIR) + "/cases/exact/tables/" + name);
  std::vector<std::vector<std::string>> table;
  for (std::string line, cell; std::getline(file, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream cells(line);
    table.emplace_back();
    while (std::getline(cells, cell, ',')) table.back().push_back(cell);
  }
  if (table.empty()) throw std::runtime_error("no table " + name);
  table.erase(table.begin());
  return table;
}

Modes modes_of(const Scene& scene, int n_elastic) {
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  return lowest_modes(model->system(), n_elastic, default_shift(model->system()));
}

TEST(SlipBoxVerification, DiscreteSpectrumOfTrilinearCubes) {
  Scene scene = one_body(Box{{1, 1, 1}}, {1, 0.3, 1}, {1, {4, 4, 4}});
  for (const auto& face : face_names(scene.bodies[0].shape))
    scene.bodies[0].supports.push_back({Support::Kind::sliding, {face, {}}});
  const Modes modes = modes_of(scene, 225);
  std::vector<double> expected;
  for (const auto& row : rows("slipbox_discrete_Q1_cube4.csv")) expected.push_back(std::stod(row[4]));
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(modes.size(), static_cast<Index>(expected.size()));
  EXPECT_EQ(modes.n_rigid, 0);
  for (Index i = 0; i < modes.size(); ++i)
    EXPECT_NEAR(modes.omega[i], expected[static_cast<size_t>(i)], 1e-10 * expected[static_cast<size_t>(i)]) << i;
}

TEST(FreeCubeVerification, SameMesh) {
  const Material material{1, 0.3, 1};
  for (const auto& row : rows("free_fem_discrete.csv")) {
    if (row[0] != "cube" || std::stoi(row[5]) > 2187 || std::stoi(row[5]) < 375) continue;  // the others take too long
    const int n = std::stoi(row[2]);
    const Modes modes = modes_of(one_body(Box{{1, 1, 1}}, material, {std::stoi(row[1]), {n, n, n}}), 20);
    ASSERT_EQ(modes.n_rigid, 6);
    for (Index i = 0; i < 20; ++i) {
      const double expected = std::stod(row[static_cast<size_t>(7 + i)]);
      EXPECT_NEAR(modes.omega[6 + i] / shear_wave_speed(material), expected, 1e-8 * expected)
          << row[1] << " " << n << " " << i;
    }
  }
}

// omega R/c_t of the free cylinder H/D = 2, nu = 0.3, every member of a multiplet.
std::vector<double> cylinder_frequencies() {
  std::vector<double> omega;
  for (const auto& row : rows("free_cylinder_HD2_nu0.3.csv"))
    for (int copy = 0; copy < std::stoi(row[5]); ++copy) omega.push_back(std::stod(row[1]));
  std::sort(omega.begin(), omega.end());
  return omega;
}

// Relative errors of the first 20 elastic omega. Nothing of unit size, so that no factor hides.
VectorXd cylinder_errors(const Resolution& resolution) {
  const Material steel{2.1e11, 0.3, 7850};
  const double radius = 0.03;
  const Modes modes = modes_of(one_body(Cylinder{radius, 4 * radius}, steel, resolution), 20);
  EXPECT_EQ(modes.n_rigid, 6);
  const auto expected = cylinder_frequencies();
  VectorXd errors(20);
  for (Index i = 0; i < 20; ++i) {
    const double Omega = modes.omega[6 + i] * radius / shear_wave_speed(steel);
    errors[i] = std::abs(Omega / expected[static_cast<size_t>(i)] - 1);
  }
  return errors;
}
TEST(FreeCylinderVerification, QuarticsOnEightyCells) {
  const VectorXd errors = cylinder_errors({4, {2, 4}});
  EXPECT_LT(errors.maxCoeff(), 1e-4);
  EXPECT_LT(errors.head(6).maxCoeff(), 1e-5);
}
TEST(FreeCylinderVerification, QuarticsOnTwentyCells) { EXPECT_LT(cylinder_errors({4, {1, 4}}).maxCoeff(), 1e-3); }

}  // namespace
}  // namespace mb
