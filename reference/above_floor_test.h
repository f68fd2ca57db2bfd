// For tests: a body that its weight drops on a rigid floor, z = 0.
#pragma once

#include "cases/scene/scene.h"

namespace mb::testing {

// With the layer that `stiffness = "auto"` chooses; no other loads.
inline Scene above_floor(Scene scene, const Vector3d& position, double duration) {
  scene.bodies[0].pose.position = position;
  scene.gravity = {0, 0, -9.81};
  scene.obstacles.push_back({"floor", {HalfSpace{}, 0, {}}});
  scene.contacts.push_back({.body = scene.bodies[0].name, .obstacle = "floor", .stiffness = 0});
  scene.duration = duration;
  scene.loads.clear();
  return scene;
}

}  // namespace mb::testing
