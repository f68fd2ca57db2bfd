// `pose = { position, axis, angle }`: where a frame stands. Turned by the angle about the axis, right-handed:
//
//   x = position + R X,   R = exp(angle [axis / |axis|]_x)
#pragma once

#include "cases/scene/section.h"
#include "mechanics/geometry/pose.h"

namespace mb {

// The pose in `key`, which is optional: that of the world where absent, nothing where something in it is wrong.
std::optional<Pose> read_pose(Section& section, const std::string& key);

// `velocity` and `angular_velocity`, both optional: zero where absent, nothing where one of them is wrong.
std::optional<Twist> read_twist(Section& section);

}  // namespace mb
