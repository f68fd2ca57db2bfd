// For verification: frequencies of bodies on real meshes beside independent ones.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "cases/exact/exact_test_table.h"
#include "cases/scene/one_body.h"
#include "mechanics/verified_test.h"
#include "modal/bases/eigenmodes.h"
#include "reference/full_model.h"

namespace mb::testing {

// Nothing of unit size, so that no factor hides.
inline const Material steel{2.1e11, 0.3, 7850};
inline constexpr double radius = 0.03;  // [m] of cylinders and spheres; cylinders are 4 radii long

// omega or f of the table's column, ascending, each as often as copies(row) says.
template <class Copies>
std::vector<double> levels(const std::string& name, size_t column, const Copies& copies) {
  std::vector<double> expected;
  for (const auto& row : numbers(name))
    for (int copy = 0; copy < copies(row); ++copy) expected.push_back(row.at(column));
  std::sort(expected.begin(), expected.end());
  return expected;
}

inline Scene with_supports(Scene scene, Support::Kind kind, const std::vector<std::string>& faces) {
  for (const std::string& face : faces) scene.bodies[0].supports.push_back({kind, {face, {}}, {}});
  return scene;
}

// Relative errors of the first n elastic omega, times a factor, against what is expected: every mode is compared, so
// that none may be missing. Without the gate, whose count of modes costs more than all else.
inline VectorXd frequency_errors(const Scene& scene, Index n_rigid, const std::vector<double>& expected, double factor,
                                 int n) {
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const System& system = model->system();
  EXPECT_EQ(system.R.cols(), n_rigid);
  const ElasticModes modes = elastic_modes(system, n, shifted_factor(system, physical_shift(scene.bodies[0])));
  VectorXd errors(n);
  for (Index i = 0; i < n; ++i)
    errors[i] = factor * std::sqrt(modes.lambda[i]) / expected.at(static_cast<size_t>(i)) - 1;
  return errors;
}

// Of any sign; infinite where one is not finite, which a maximum would drop.
inline double largest(const VectorXd& errors) {
  return errors.allFinite() ? errors.cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity();
}

// log2(e_coarse/e_fine) of meshes whose cells differ by a factor of 2.
inline VectorXd order(const VectorXd& coarse, const VectorXd& fine) {
  return (coarse.array() / fine.array()).log() / std::log(2.0);
}

// Errors on three meshes, each halved: all positive (Ritz), falling; the orders of the finer pair within bounds.
inline VectorXd expect_order(const std::array<VectorXd, 3>& errors, double at_least, double at_most) {
  for (Index i = 0; i < errors[0].size(); ++i) {
    EXPECT_GT(errors[2][i], 0) << i;
    EXPECT_GT(errors[1][i], errors[2][i]) << i;
    EXPECT_GT(errors[0][i], errors[1][i]) << i;
  }
  const VectorXd observed = order(errors[1], errors[2]);
  EXPECT_GE(observed.minCoeff(), at_least) << observed.transpose();
  EXPECT_LE(observed.maxCoeff(), at_most) << observed.transpose();
  return observed;
}

}  // namespace mb::testing
