#include "modal/bases/gate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/algebra/box_test_system.h"
#include "mechanics/algebra/noise.h"
#include "modal/bases/eigenmodes.h"

namespace mb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A free cube: elastic multiplets of 2, 3, 3, 3, 2 ... Modes 7-8, 9-11, 12-14 in the gate's counting.
class Gate : public ::testing::Test {
 protected:
  const System cube = testing::box_system({.cells = {4, 4, 4}, .E = 7e10, .rho = 2700}).system;
  const Modes good = lowest_modes(cube, 20, -0.01 * 7e10 / 2700);

  // Columns by index, repeated or left out at will.
  Modes only(const std::vector<Index>& columns) const {
    return {good.n_rigid, good.omega(columns), good.Phi(Eigen::all, columns), good.residual(columns), good.lambda_max};
  }
  std::vector<Index> all_columns() const {
    std::vector<Index> columns(static_cast<size_t>(good.size()));
    for (size_t i = 0; i < columns.size(); ++i) columns[i] = static_cast<Index>(i);
    return columns;
  }
  std::string failure(const Modes& modes, Index n_keep) const {
    try {
      check_modes(cube, modes, n_keep);
    } catch (const GateFailure& error) {
      return error.what();
    }
    return "passed";
  }
};

TEST_F(Gate, PassesGoodModes) {
  EXPECT_EQ(failure(good, 6), "passed");
  EXPECT_EQ(failure(good, 8), "passed");
  EXPECT_EQ(failure(good, 14), "passed");
}

TEST_F(Gate, FindsADroppedMode) {
  for (const Index dropped : {6, 8, 10, 13}) {
    auto columns = all_columns();
    columns.erase(columns.begin() + dropped);
    EXPECT_THAT(failure(only(columns), 13), HasSubstr("14 modes lie below")) << dropped;
  }
}

TEST_F(Gate, FindsAPerturbedMode) {
  Modes modes = good;
  modes.Phi.col(9) += 1e-6 * modes.Phi.col(9).norm() * uniform_noise(modes.Phi.rows(), 1);
  EXPECT_THAT(failure(modes, 14), AllOf(HasSubstr("mode 10 (elastic"), HasSubstr("residual"), HasSubstr("exceeds")));
  modes = good;
  modes.omega(9) *= 1 + 1e-7;  // its copies no longer in order, or its residual too large
  EXPECT_NE(failure(modes, 14), "passed");
}

TEST_F(Gate, FindsADuplicatedMode) {
  Modes modes = good;
  modes.Phi.col(7) = modes.Phi.col(6);
  EXPECT_THAT(failure(modes, 14), AllOf(HasSubstr("modes 8 and 7"), HasSubstr("phi^T M phi")));
}

TEST_F(Gate, FindsWrongScale) {
  Modes modes = good;
  modes.Phi.col(12) *= 1 + 1e-9;
  EXPECT_THAT(failure(modes, 14), HasSubstr("modes 13 and 13"));
}

TEST_F(Gate, FindsACutMultiplet) {
  EXPECT_THAT(failure(good, 10), HasSubstr("modes 10 and 11"));
  // One of a triplet missing altogether, the cut right behind it.
  auto columns = all_columns();
  columns.erase(columns.begin() + 10);
  EXPECT_THAT(failure(only(columns), 10), HasSubstr("11 modes lie below"));
}

TEST_F(Gate, FindsARigidModeThatIsNot) {
  Modes modes = good;
  modes.Phi.col(3) = modes.Phi.col(6);
  EXPECT_THAT(failure(modes, 14), HasSubstr("mode 4 (rigid"));
  modes = good;
  modes.omega(5) = 1e-3;
  EXPECT_THAT(failure(modes, 14), HasSubstr("mode 6"));
  auto columns = all_columns();
  columns.erase(columns.begin());
  modes = only(columns);
  modes.n_rigid = 5;
  EXPECT_THAT(failure(modes, 13), HasSubstr("5 rigid modes where the supports leave 6"));
}

TEST_F(Gate, FindsWhatIsNoNumber) {
  Modes modes = good;
  modes.omega(8) = NAN;
  EXPECT_THAT(failure(modes, 14), HasSubstr("mode 9"));
  modes = good;
  modes.Phi(0, 8) = NAN;
  EXPECT_THAT(failure(modes, 14), HasSubstr("mode 9"));
}

// Ever more slender rods, whose first frequency falls beside the highest of their mesh: certified down to where
// rounding may make a hundredth of lambda, refused below.
TEST(GateOfSlenderRods, SaysWhereAFrequencyIsNextToZero) {
  int n_certified = 0, n_refused = 0;
  for (const double length : {1., 2., 4., 8., 16.}) {
    const System rod = testing::box_system({.cells = {1, 1, 12},
                                            .degree = 2,
                                            .size = {0.01, 0.01, length},
                                            .E = 2e11,
                                            .rho = 7850,
                                            .fixed = [](const Vector3d& x, int) { return x.z() < 1e-9; }})
                           .system;
    try {
      const Modes found = lowest_modes(rod, 4, -0.01 * 2e11 / (7850 * length * length));
      EXPECT_LE(50 * std::numeric_limits<double>::epsilon() * found.lambda_max, 0.01 * std::pow(found.omega(0), 2));
      EXPECT_EQ(n_refused, 0) << length;
      ++n_certified;
    } catch (const GateFailure& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr("mode 1"), HasSubstr("so near to zero"))) << length;
      ++n_refused;
    }
  }
  EXPECT_GE(n_certified, 1);
  EXPECT_GE(n_refused, 1);
}

TEST_F(Gate, NeedsAGapToCountIn) {
  EXPECT_THAT(failure(only({0, 1, 2, 3, 4, 5, 6, 7}), 8), HasSubstr("no cut above mode 8"));
}

TEST_F(Gate, RefusesWrongSizes) {
  EXPECT_THROW(check_modes(cube, good, 5), std::invalid_argument);
  EXPECT_THROW(check_modes(cube, good, good.size() + 1), std::invalid_argument);
  Modes modes = good;
  modes.lambda_max = 0;
  EXPECT_THROW(check_modes(cube, modes, 14), std::invalid_argument);
  modes = good;
  modes.Phi.conservativeResize(7, Eigen::NoChange);
  EXPECT_THROW(check_modes(cube, modes, 14), std::invalid_argument);
}

}  // namespace
}  // namespace mb
