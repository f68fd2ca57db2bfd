// Scenes for which the closed forms hold, of no special dimensions, for tests.
#pragma once

#include "cases/scene/one_body.h"

namespace mb {

inline Support support(Support::Kind kind, const std::string& face) {
  return {kind, {face, std::nullopt}, std::nullopt};
}

// A rod of 0.2 x 0.3 x 1.7 m under a step of 4e5 Pa x 1.5, from 1e-4 s on, at the face.
inline Scene rod_scene(const std::string& face, const std::vector<Support>& supports) {
  Scene scene = one_body(Box{Vector3d(0.2, 0.3, 1.7)}, {3e9, 0, 1200, {}}, {1, {1, 1, 4}});
  scene.bodies[0].supports = supports;
  scene.loads = {{"pull", Step{1.5, 1e-4}, {{"body", {face, std::nullopt}, Vector3d(0, 0, 4e5), 0}}}};
  scene.duration = 0.02;
  scene.samples_per_second = scene.frame_rate = 1e4;
  scene.probes = {{"end", "body", Vector3d(0.1, -0.1, 0.85), Vector3d::UnitZ()}};
  return scene;
}

// A sphere of 0.3 m under a pulse of 2e6 Pa x 0.7, from 2e-5 s on for 1.5e-4 s; c_l = 3651 m/s.
inline Scene sphere_scene() {
  Scene scene = one_body(Sphere{0.3}, {20e9, 0.21, 1700, {}}, {2, {2}});
  scene.loads = {{"squeeze", Pulse{1.5e-4, 0.7, 2e-5}, {{"body", {"surface", std::nullopt}, Vector3d::Zero(), 2e6}}}};
  scene.duration = 6e-4;
  scene.samples_per_second = scene.frame_rate = 1e5;
  scene.probes = {{"surface", "body", Vector3d(0, 0.3, 0), Vector3d::UnitY()},
                  {"centre", "body", Vector3d::Zero(), Vector3d::UnitY()}};
  return scene;
}

}  // namespace mb
