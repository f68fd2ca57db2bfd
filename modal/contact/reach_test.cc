#include "modal/contact/reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "modal/contact/floating_bodies_test.h"
#include "modal/contact/sample_tables.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::floating;
using testing::ground;
using testing::random_modes;
using testing::samples_of;

const Shape block = Box{{0.1, 0.08, 0.06}};

struct Setting {
  FloatingBody body;
  const SampledContact& contact() const { return body.contacts[0]; }
};
Setting setting(const RigidSurface& obstacle) {
  Setting s{floating(block, {roots({1e6, 0}), roots({4e6, 0})}, {0, 0, 0})};
  SurfaceSamples samples = samples_of(block, random_modes(block, 2, 2, 1, 3), {0.008, 0.008, 0, 2});
  samples.Psi = random_modes(block, 2, 2, 1e-2, 4).at(samples.X);
  s.body.static_stiffness = MatrixXd::Identity(2, 2);
  s.body.contacts.push_back({samples, obstacle, {1e9, 0, {}}});
  return s;
}
VectorXd gaps(const Setting& s, const BodyState& at) {
  const SurfaceSamples& of = s.contact().samples;
  VectorXd all(of.w.size());
  for (Index i = 0; i < all.size(); ++i)
    all[i] = gap_value(s.contact().surface, at.c + at.Q * (of.X.col(i) + of.Phi.middleRows(3 * i, 3) * at.q +
                                                           of.Psi.middleRows(3 * i, 3) * at.s));
  return all;
}

// A body that wanders about in small steps and sometimes jumps, turning and deforming: whoever presses is listed.
TEST(Reach, MissesNoSampleThatPresses) {
  for (const RigidSurface& obstacle : {ground, RigidSurface{Sphere{0.2}, 0, {{0, 0, -0.2}, {1, 0, 0, 0}}}}) {
    const Setting s = setting(obstacle);
    Reach reach(s.contact());
    std::mt19937 random(21);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vector3d(normal(random), normal(random), normal(random)); };
    BodyState at = at_rest(s.body, {0, 0, 0.032});
    const Index m = s.contact().samples.w.size();
    long n_pressed = 0, n_made = 0;
    double visited = 0;
    const int n_looks = 3000;
    for (int look = 0; look < n_looks; ++look) {
      const double size = look % 500 == 499 ? 1e-2 : look % 50 == 49 ? 1e-3 : 3e-6;
      at.c += size * 0.1 * vector(), at.c.z() += 0.01 * (0.032 - at.c.z());
      at.Q = (at.Q * Eigen::Quaterniond(1, 0, 0, 0).slerp(std::min(1.0, size), Eigen::Quaterniond::UnitRandom()))
                 .normalized();
      if (look % 300 == 0) at.Q.setIdentity();
      at.q += size * Eigen::Vector2d(normal(random), normal(random)), at.q *= 0.999;
      at.s += size * Eigen::Vector2d(normal(random), normal(random)), at.s *= 0.999;
      const VectorXd gap = gaps(s, at);
      const Index n = reach.n_reachable(at, [&] {
        ++n_made;
        return gap;
      });
      ASSERT_LE(n, m);
      std::set<Index> listed;
      for (Index k = 0; k < n; ++k) listed.insert(reach[k]);
      ASSERT_EQ(static_cast<Index>(listed.size()), n);  // each once
      Index pressing = 0;
      for (Index i = 0; i < m; ++i) {
        if (!(gap[i] < 0)) continue;
        ++pressing;
        ASSERT_TRUE(listed.contains(i)) << look << " misses " << gap[i];
      }
      reach.pressed(pressing);
      n_pressed += pressing;
      visited += static_cast<double>(n);
    }
    EXPECT_GT(n_pressed, n_looks);                               // they do press
    EXPECT_LT(n_made, n_looks / 4);                              // lists serve
    EXPECT_LT(visited, 0.5 * static_cast<double>(m) * n_looks);  // and are short
  }
}

// What static shapes do after the look: covered or not, with the answer after a second look.
TEST(Reach, CoversWhatStaticShapesMove) {
  const Setting s = setting(ground);
  std::mt19937 random(22);
  std::normal_distribution<double> normal;
  int n_uncovered = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Reach reach(s.contact());
    BodyState at = at_rest(s.body, {0, 0, 0.0305 + 2e-4 * normal(random)});
    const VectorXd shifted = 0.02 * Eigen::Vector2d(normal(random), normal(random));
    for (bool covered = false; !covered;) {
      const Index n = reach.n_reachable(at, [&] { return gaps(s, at); });
      covered = reach.covers(shifted);
      if (!covered) {
        ++n_uncovered;
        at.s = shifted;
        continue;
      }
      BodyState then = at;
      then.s = shifted;
      const VectorXd gap = gaps(s, then);
      std::set<Index> listed;
      for (Index k = 0; k < n; ++k) listed.insert(reach[k]);
      for (Index i = 0; i < gap.size(); ++i) ASSERT_TRUE(!(gap[i] < 0) || listed.contains(i)) << trial;
    }
  }
  EXPECT_GT(n_uncovered, 0);
}

TEST(Reach, FarAwayThereIsNothing) {
  const Setting s = setting(ground);
  Reach reach(s.contact());
  const BodyState at = at_rest(s.body, {0, 0, 10});
  EXPECT_EQ(reach.n_reachable(at, [&] { return gaps(s, at); }), 0);
}

TEST(Reach, LargestDisplacementsByHand) {
  MatrixXd shapes(6, 2);
  shapes << 1, 0, 2, 0, 2, -1, 0, 3, 4, 0, 0, 4;  // |(1,2,2)| = 3, |(0,4,0)| = 4; |(0,0,-1)| = 1, |(3,0,4)| = 5
  EXPECT_EQ(largest_displacements(shapes), (Eigen::Vector2d(4, 5)));
  EXPECT_EQ(largest_displacements(MatrixXd(0, 2)), (Eigen::Vector2d(0, 0)));
  EXPECT_EQ(largest_displacements(MatrixXd(6, 0)).size(), 0);
}

}  // namespace
}  // namespace mb
