#include "modal/contact/sample_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "modal/contact/floating_bodies_test.h"

namespace mb::testing {
namespace {

// A ball, deformed, above a plane of any normal: heights by hand against those that come out of the tree.
TEST(SampleTree, TheNearestComeFirst) {
  const Shape ball = Sphere{0.05};
  const PolynomialBasis modes = random_modes(ball, 3, 4, 0.3, 5);
  const SurfaceSamples samples = samples_of(ball, modes, {1e-3, 8e-3, 0.3, 2}, {Vector3d(0, 0, -0.05)});
  const Index m = samples.w.size();
  const SampleTree tree(samples.X, samples.Phi);
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    Vector3d n(0.3 * normal(random), 0.3 * normal(random), 1);
    n.normalize();
    VectorXd q(4);
    for (double& x : q) x = 1e-3 * normal(random);
    const VectorXd u = samples.Phi * q;
    const VectorXd height = n.transpose() * (samples.X + u.reshaped(3, m));
    const auto bound = [&](const SampleTree::Extent& of) { return height[of.sample] + of.along(n) - of.spread; };
    const Neighbours list = tree.nearest(bound, q.cwiseAbs(), {50, 2, -0.0499});
    ASSERT_GE(std::ssize(list.order), 50);
    ASSERT_TRUE(std::ranges::is_sorted(list.gap));
    std::set<Index> listed(list.order.begin(), list.order.end());
    ASSERT_EQ(listed.size(), list.order.size());
    Index n_within = 0;
    for (Index i = 0; i < m; ++i) {
      if (!listed.contains(i)) {
        EXPECT_GE(height[i], list.beyond) << trial;
      }
      if (height[i] <= -0.0499) ++n_within;
    }
    for (size_t k = 0; k < list.order.size(); ++k) {
      EXPECT_EQ(list.gap[k], height[list.order[k]]);
      EXPECT_LE(list.gap[k], list.beyond);
    }
    EXPECT_GE(std::ssize(list.order), std::min(m, 2 * n_within));
    EXPECT_LT(list.n_looked, m / 2);  // a few hundred
  }
}

TEST(SampleTree, AllOfThemAndNone) {
  const SampleTree none(Matrix3Xd(3, 0), MatrixXd(0, 0));
  const auto bound = [](const SampleTree::Extent& of) { return static_cast<double>(of.sample); };
  EXPECT_TRUE(none.nearest(bound, VectorXd(0), {5, 4, 0}).order.empty());
  const SampleTree same(Matrix3Xd::Ones(3, 40), MatrixXd(120, 0));  // no two of them differ
  const auto level = [](const SampleTree::Extent& of) { return 1 + of.along(Vector3d::UnitZ()); };
  const Neighbours all = same.nearest(level, VectorXd(0), {100, 4, 0});
  EXPECT_EQ(all.order.size(), 40);
  EXPECT_EQ(all.beyond, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace mb::testing
