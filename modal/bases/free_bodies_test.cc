// Free bodies: frequencies of the continuum, to the order of the elements. Below the leading error h^2 or h^4 of the
// bounds, the meshes are coarse yet for some modes, above it for others.
#include <gtest/gtest.h>

#include "mechanics/verified_test.h"
#include "modal/bases/verification_test.h"

namespace mb {
namespace {

using testing::expect_order;
using testing::expect_verified;
using testing::frequency_errors;
using testing::largest;
using testing::levels;
using testing::radius;
using testing::steel;

std::array<VectorXd, 3> on_three_meshes(const Shape& shape, const std::vector<double>& expected, double length, int n,
                                        const std::array<Resolution, 3>& meshes) {
  std::array<VectorXd, 3> errors;
  for (size_t i = 0; i < 3; ++i)
    errors[i] = frequency_errors(one_body(shape, steel, meshes[i]), 6, expected, length / shear_wave_speed(steel), n);
  return errors;
}

// Multiplets 2, 3, 3, 3, 3, 3: the first 17.
const double edge = 0.2;  // [m]
std::array<VectorXd, 3> cube(const std::array<Resolution, 3>& meshes) {
  const auto expected = levels("free_cube_nu0.3.csv", 1, [](const auto&) { return 1; });
  return on_three_meshes(Box{{edge, edge, edge}}, expected, edge, 17, meshes);
}
TEST(FreeCubeVerification, TrilinearOrder) {
  expect_order(cube({{{1, {4, 4, 4}}, {1, {8, 8, 8}}, {1, {16, 16, 16}}}}), 1.9, 2.05);
}
TEST(FreeCubeVerification, QuadraticOrder) {
  const auto errors = cube({{{2, {2, 2, 2}}, {2, {4, 4, 4}}, {2, {8, 8, 8}}}});
  const VectorXd orders = expect_order(errors, 3.5, 4.1);
  EXPECT_LT(errors[2].maxCoeff(), 3e-4);
  expect_verified(
      {.quantity = "distance from 4 of the orders in which 17 frequencies of a free cube converge, quadratics "
                   "of 4 and 8 cells an edge, the worst",
       .reference = "converged numbers",
       .source = "Rayleigh-Ritz in polynomials up to degree 34: free_cube_nu0.3.csv",
       .uncertainty = "4e-9 of the frequencies, change from degree 30 to 34",
       .tolerance = 0.5,
       .why = "Twice the degree in the limit; below it for modes whose waves 4 cells an edge hardly resolve. "
              "Above 4 the test allows 0.1."},
      largest(orders.array() - 4));
}

std::vector<double> cylinder_levels() {
  return levels("free_cylinder_HD2_nu0.3.csv", 1, [](const auto& row) { return static_cast<int>(row[5]); });
}
std::array<VectorXd, 3> cylinder(const std::array<Resolution, 3>& meshes) {
  return on_three_meshes(Cylinder{radius, 4 * radius}, cylinder_levels(), radius, 9, meshes);
}
TEST(FreeCylinderVerification, TrilinearOrder) {
  expect_order(cylinder({{{1, {2, 8}}, {1, {4, 16}}, {1, {8, 32}}}}), 1.9, 2.05);
}
TEST(FreeCylinderVerification, QuadraticOrder) {
  const auto errors = cylinder({{{2, {1, 2}}, {2, {2, 4}}, {2, {4, 8}}}});
  expect_order(errors, 3.5, 4.1);
  EXPECT_LT(errors[2].head(7).maxCoeff(), 1e-3);
}
TEST(FreeCylinderVerification, QuarticsOnFewCells) {
  const auto errors = [](const Resolution& resolution) {
    return frequency_errors(one_body(Cylinder{radius, 4 * radius}, steel, resolution), 6, cylinder_levels(),
                            radius / shear_wave_speed(steel), 20);
  };
  const VectorXd twenty = errors({4, {1, 4}}), eighty = errors({4, {2, 4}});
  EXPECT_LT(twenty.maxCoeff(), 1e-3);
  EXPECT_LT(eighty.head(6).maxCoeff(), 1e-5);
  expect_verified(
      {.quantity = "20 frequencies of a free cylinder twice as long as wide, 80 quartic cells, relative, the "
                   "worst",
       .reference = "converged numbers",
       .source = "Fourier-Ritz, 16 radial terms and axial degree 42: free_cylinder_HD2_nu0.3.csv",
       .uncertainty = "7e-10, nine printed decimals",
       .tolerance = 1e-4,
       .why = "The shortest waves among the 20 set it, on four layers of cells along the axis; the first six "
              "modes are held to 1e-5."},
      largest(eighty));
}

// Lamb's spectrum, multiplets of 2 l + 1: T2 5, S2 5, S1 3, T3 7. Each splits on a mesh, by less than its error.
std::array<VectorXd, 3> sphere(const std::array<Resolution, 3>& meshes) {
  const auto expected = levels("sphere_exact_nu0.3.csv", 5, [](const auto& row) { return static_cast<int>(row[4]); });
  return on_three_meshes(Sphere{radius}, expected, radius, 20, meshes);
}
TEST(FreeSphereVerification, TrilinearOrder) { expect_order(sphere({{{1, {2}}, {1, {4}}, {1, {8}}}}), 1.9, 2.05); }
TEST(FreeSphereVerification, QuadraticOrder) {
  const auto errors = sphere({{{2, {1}}, {2, {2}}, {2, {4}}}});
  const VectorXd orders = expect_order(errors, 3.5, 4.3);
  EXPECT_LT(errors[2].maxCoeff(), 1.1e-3);
  expect_verified(
      {.quantity =
           "distance from 4 of the orders in which 20 frequencies of a free sphere converge, quadratics of 56 and "
           "448 cells, the worst",
       .reference = "exact solution",
       .source = "Lamb 1882, Proc. London Math. Soc. 13: sphere_exact_nu0.3.csv",
       .uncertainty = "1e-12 of the frequencies, of the roots",
       .tolerance = 0.5,
       .why = "Twice the degree in the limit, on the curved boundary as well; 56 cells are coarse yet for some modes. "
              "Above 4 the test allows 0.3."},
      largest(orders.array() - 4));
}

// Five frequencies in Hz, bending ones twice, six rigid modes; the figures have seven digits.
TEST(AluminiumCylinderVerification, FirstFrequencies) {
  const Scene scene = one_body(Cylinder{0.1524, 0.6096}, {7e10, 0.33, 2700}, {4, {2, 4}});
  const std::vector<double> hertz = {2546.759, 2546.759, 2560.657, 4099.993, 4693.295, 4693.295, 5121.313};
  const VectorXd errors = frequency_errors(scene, 6, hertz, 1 / (2 * pi), 7);
  expect_verified(
      {.quantity = "first seven elastic frequencies of a free aluminium cylinder, nu = 0.33, 80 quartic "
                   "cells, relative, the worst",
       .reference = "converged numbers",
       .source = "independent computation to seven digits; published ones of Abaqus, C3D10, are 2e-6 to 6e-5 "
                 "higher",
       .uncertainty = "2e-7, the digits",
       .tolerance = 1e-5,
       .why = "What 80 quartic cells keep in the lowest modes of the cylinder of nu = 0.3, too."},
      largest(errors));
}

// The six motions of a rigid body are in the space of any mesh, and cost no strain.
TEST(RigidModesVerification, AreSixWithoutStrain) {
  for (const Shape& shape : {Shape(Box{{0.1, 0.2, 0.5}}), Shape(Cylinder{radius, 4 * radius}), Shape(Sphere{radius})}) {
    const std::vector<int> cells = std::holds_alternative<Box>(shape)        ? std::vector{2, 3, 4}
                                   : std::holds_alternative<Cylinder>(shape) ? std::vector{1, 4}
                                                                             : std::vector{1};
    const Scene scene = one_body(shape, steel, {2, cells});
    const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
    const Modes modes = lowest_modes(model->system(), 1, physical_shift(scene.bodies[0]));
    ASSERT_EQ(modes.n_rigid, 6);
    // |omega^2| <= |K phi|/|M phi| = residual lambda_1
    EXPECT_LE(modes.residual.head(6).maxCoeff(), 1e-9);
    EXPECT_GT(modes.omega(6), 0);
  }
}

}  // namespace
}  // namespace mb
