// The bodies of post-drop-*: nearly equal in their low-order moments, in nothing else.
#include <gtest/gtest.h>

#include <algorithm>

#include "cases/contract/touchdown.h"
#include "cases/scene/case_files.h"
#include "mechanics/geometry/tapered.h"
#include "mechanics/rigid/inertia.h"

namespace mb {
namespace {

Scene scene_of(const std::string& name) {
  return read_toml(test::cases_folder() / ("post-drop-" + name + ".toml"), test::vocabulary(), "standard");
}

const std::vector<std::string> names = {"pebble", "pillow", "pear"};

// By 0.5 % and 0.8 %, as four digits of the semi-axes allow.
TEST(PostDrop, bodies_have_nearly_equal_moments) {
  const Body pebble = scene_of("pebble").bodies[0];
  const MassProperties expected = mass_properties(pebble.shape, pebble.material.density);
  EXPECT_NEAR(expected.mass, 3.299, 5e-4);
  EXPECT_LT((expected.inertia.diagonal() - Vector3d(0.01098, 0.01387, 0.01031)).cwiseAbs().maxCoeff(), 1e-5);
  for (const std::string& name : names) {
    const Body body = scene_of(name).bodies[0];
    const MassProperties found = mass_properties(body.shape, body.material.density);
    EXPECT_NEAR(found.mass, expected.mass, 0.006 * expected.mass) << name;
    EXPECT_LT((found.inertia - expected.inertia).norm(), 0.008 * expected.inertia.norm()) << name;
    EXPECT_NEAR(extent(body.shape), 0.2, 0.025) << name;
  }
}

TEST(PostDrop, the_pear_differs_in_its_third_moments) {
  const auto pear = std::get<TaperedSuperquadric>(scene_of("pear").bodies[0].shape);
  const double skew = moment(pear, 0, 0, 3) / volume(pear) / std::pow(moment(pear, 0, 0, 2) / volume(pear), 1.5);
  EXPECT_NEAR(skew, -0.286, 1e-3);
  EXPECT_EQ(std::get<Superquadric>(scene_of("pebble").bodies[0].shape).e1, 1);
  EXPECT_EQ(std::get<Superquadric>(scene_of("pillow").bodies[0].shape).e1, 0.6);
}

// A metre of fall to a tenth of a millimetre, onto the flat top, beside the centroid: the sign of the turn is that of
// the lever, y of the touch less y of the centroid.
TEST(PostDrop, each_falls_a_metre_and_is_turned_about_x) {
  for (const std::string& name : names) {
    const Scene scene = scene_of(name);
    const Touchdown down = touchdown(scene, scene.bodies[0]);
    ASSERT_EQ(down.meetings.size(), 1u);
    EXPECT_NEAR(9.81 / 2 * down.t * down.t, 1, 1e-4) << name;
    const Vector3d lever = scene.bodies[0].pose.orientation * down.meetings[0].X;
    EXPECT_GT(lever.y(), 0.027) << name;
    EXPECT_LT(std::abs(scene.bodies[0].pose.position.y() + lever.y()), 0.04) << name;
    EXPECT_NEAR(lever.x(), 0, 1e-6) << name;  // flat across: found to the root of rounding
  }
}

}  // namespace
}  // namespace mb
