// Modes of a beam on two meshes, held against each other by how they move.
#include "modal/bases/mode_pairs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "modal/bases/eigenmodes.h"
#include "modal/bases/verification_test.h"
#include "reference/full_model.h"

namespace mb {
namespace {

const MatrixXd four = MatrixXd::Identity(5, 4);

TEST(ModePairs, FollowModesThatChangePlaces) {
  MatrixXd other(5, 4);
  other << four.col(0), -four.col(2), four.col(1), VectorXd::Unit(5, 4);
  const ModePairs pairs = mode_pairs(four, other);
  EXPECT_EQ(pairs, (ModePairs{{0}, {2}, {1}, {}}));
}

// Of a pair that is rotated either holds half of both.
TEST(ModePairs, OfAMultipletAreAllOfIt) {
  MatrixXd other = four;
  other.col(1) = (four.col(1) + four.col(2)) / std::sqrt(2);
  other.col(2) = (four.col(1) - four.col(2)) / std::sqrt(2);
  EXPECT_EQ(mode_pairs(four, other), (ModePairs{{0}, {1, 2}, {1, 2}, {3}}));
  const VectorXd of_other{{1, 2.1, 1.8, 3}};
  EXPECT_EQ(farthest(2, of_other, {1, 2}), 2);
  EXPECT_EQ(farthest(2, of_other, {1}), 1);
  EXPECT_EQ(farthest(2, of_other, {}), -1);
}

// A box nearly square across: bending in pairs, torsion and extension between them, whose frequencies fall by different
// shares from mesh to mesh. Each is paired with its own alone: the quadrature tells them apart.
TEST(ModePairs, OfABeamOnTwoMeshesAreOneToOne) {
  const auto seen_on = [](const Resolution& mesh, int n) {
    const Scene scene = one_body(Box{{0.1, 0.11, 0.6}}, testing::steel, mesh);
    const Body& body = scene.bodies[0];
    const auto full = full_model(scene, body, body.resolution);
    const Modes modes = lowest_modes(full->system(), n, physical_shift(body));
    return seen_at(*full, volume_quadrature(body.shape), modes.Phi.middleCols(modes.n_rigid, n));
  };
  const MatrixXd coarse = seen_on({1, {1, 1, 4}}, 8), fine = seen_on({2, {1, 1, 6}}, 14);
  const ModePairs pairs = mode_pairs(coarse, fine);
  bool is_in_order = true;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ASSERT_EQ(pairs[i].size(), 1u) << i;
    EXPECT_GT(std::pow(coarse.col(static_cast<Index>(i)).dot(fine.col(pairs[i][0])), 2), 0.8) << i;
    is_in_order = is_in_order && pairs[i][0] == static_cast<Index>(i);
  }
  EXPECT_FALSE(is_in_order) << "linear elements are too stiff in bending: torsion comes first there";
}

}  // namespace
}  // namespace mb
