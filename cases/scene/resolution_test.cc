#include "cases/scene/resolution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb {
namespace {

TEST(MeshSize, counts_the_nodes_of_each_shape) {
  const Shape box = Box{{1, 1, 1}}, cylinder = Cylinder{0.05, 0.2}, sphere = Sphere{1};
  EXPECT_EQ(n_dofs(box, {1, {1, 1, 1}}), 24);
  EXPECT_EQ(n_dofs(box, {2, {2, 3, 4}}), 3 * 5 * 7 * 9);
  // Published sizes of the free cylinder: Q2 with 17,187 and 2,403, Q4 on 20 and 80 cells with 4,539 and 17,187.
  EXPECT_EQ(n_dofs(cylinder, {4, {1, 4}}), 4539);
  EXPECT_EQ(n_dofs(cylinder, {4, {2, 4}}), 17187);
  EXPECT_EQ(n_dofs(cylinder, {3, {2, 4}}), 7527);
  // One block across: 9 nodes of degree 2 a layer, 5 layers of nodes.
  EXPECT_EQ(n_dofs(cylinder, {2, {0, 2}}), 3 * 9 * 5);
  // One ball of seven bricks has 16 corners.
  EXPECT_EQ(n_dofs(sphere, {1, {1}}), 48);
}

TEST(MeshSize, refuses_meshes_that_cannot_be_made) {
  const Shape cylinder = Cylinder{0.05, 0.2}, sphere = Sphere{1};
  Findings findings("f.toml", "");
  EXPECT_TRUE(check_mesh(cylinder, {4, {2, 3}}, {}, findings));
  EXPECT_TRUE(findings.empty());
  EXPECT_FALSE(check_mesh(cylinder, {4, {3, 4}}, {}, findings));
  EXPECT_FALSE(check_mesh(cylinder, {4, {4}}, {}, findings));
  EXPECT_FALSE(check_mesh(sphere, {1, {6}}, {}, findings));
  EXPECT_FALSE(check_mesh(sphere, {4, {256}}, {}, findings));
  EXPECT_FALSE(check_mesh(cylinder, {2, {1, 0}}, {}, findings));
  EXPECT_FALSE(check_mesh(Box{{1, 1, 1}}, {2, {0, 1, 1}}, {}, findings));
  EXPECT_EQ(findings.found().size(), 6u);
}

TEST(Ranges, know_open_ends_and_no_nan) {
  const Range poisson{-1, 0.5, "", true, true};
  EXPECT_TRUE(poisson.contains(0.499999));
  EXPECT_FALSE(poisson.contains(0.5));
  EXPECT_FALSE(poisson.contains(-1));
  EXPECT_FALSE(poisson.contains(std::nan("")));
  EXPECT_EQ(to_string(poisson), "(-1, 0.5)");
  EXPECT_EQ(to_string(Range{0, 1e5, "s", true}), "(0, 100000] s");
  EXPECT_EQ(to_string(Range{1e-6, 1e13, "Pa"}), "[1e-6, 1e13] Pa");
  EXPECT_EQ(to_string(Range{-1e-12, 2.5e100}), "[-1e-12, 2.5e100]");
}

}  // namespace
}  // namespace mb
