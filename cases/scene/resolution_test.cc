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
  // Superquadrics have the ball's blocks.
  const Superquadric stone{{1, 2, 3}, 0.5, 1.2};
  EXPECT_EQ(n_dofs(stone, {3, {4}}), n_dofs(sphere, {3, {4}}));
  EXPECT_EQ(n_dofs(TaperedSuperquadric{stone, 0.3}, {3, {4}}), n_dofs(sphere, {3, {4}}));
}

// A box of cubes: each grading adds 7/8 of the children of 1.5 x 14.5 cells, p^3 nodes each. Against real meshes:
// reference/graded_model_test.cc.
TEST(MeshSize, of_graded_meshes_grows_by_as_much_each_time) {
  const Shape box = Box{{1, 1, 1}}, sphere = Sphere{1}, cylinder = Cylinder{0.05, 0.2};
  const auto n = [&](const Shape& shape, const Resolution& even, int graded) {
    return n_dofs(shape, {even.degree, even.cells, graded});
  };
  const double halved = pi * std::pow(1.1 * std::sqrt(3.0), 3);
  for (int graded = 1; graded <= 12; ++graded)
    EXPECT_NEAR(n(box, {2, {4, 4, 4}}, graded) - n(box, {2, {4, 4, 4}}, 0), 3 * 8 * 7 * halved * graded, 1e-6);
  // Never more than all cells: the first time, one cell becomes eight.
  EXPECT_EQ(n(box, {1, {1, 1, 1}}, 1) - n(box, {1, {1, 1, 1}}, 0), 3 * 7);
  for (const auto& [shape, even] : std::vector<std::pair<Shape, Resolution>>{
           {sphere, {3, {2}}}, {cylinder, {2, {1, 4}}}, {cylinder, {2, {0, 4}}}}) {
    EXPECT_GT(n(shape, even, 1), n(shape, even, 0));
    EXPECT_NEAR(n(shape, even, 6) - n(shape, even, 5), n(shape, even, 5) - n(shape, even, 4), 1e-6);
  }
}

TEST(GradedResolution, compares_and_prints) {
  EXPECT_EQ(to_string(Resolution{2, {1}, 4}), "Q2 1 graded 4");
  EXPECT_EQ(to_string(Resolution{2, {1, 3}, 0}), "Q2 1x3");
  EXPECT_EQ((Resolution{2, {1}, 4}), (Resolution{2, {1}, 4}));
  EXPECT_FALSE((Resolution{2, {1}, 4}) == (Resolution{2, {1}, 3}));
  EXPECT_FALSE((Resolution{2, {1}, 4}) == (Resolution{2, {1}}));
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
  EXPECT_TRUE(check_mesh(Superquadric{{1, 2, 3}, 0.5, 1.2}, {4, {4}}, {}, findings));
  EXPECT_FALSE(check_mesh(Superquadric{{1, 2, 3}, 0.5, 1.2}, {4, {4, 4}}, {}, findings));
  EXPECT_FALSE(check_mesh(cylinder, {2, {1, 0}}, {}, findings));
  EXPECT_FALSE(check_mesh(Box{{1, 1, 1}}, {2, {0, 1, 1}}, {}, findings));
  EXPECT_TRUE(check_mesh(Box{{1, 1, 0.01}}, {4, {8, 8, 1}, 4}, {}, findings));  // flat cells: many lie near
  EXPECT_FALSE(check_mesh(Box{{1, 1, 0.01}}, {4, {8, 8, 1}, 12}, {}, findings));
  EXPECT_EQ(findings.found().size(), 8u);
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
