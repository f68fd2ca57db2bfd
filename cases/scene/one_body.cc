#include "cases/scene/one_body.h"

namespace mb {

Scene one_body(const Shape& shape, const Material& material, const Resolution& resolution) {
  Scene scene{};
  scene.name = "one-body";
  scene.bodies.push_back({"body", shape, material, {}, {}, resolution, {}});
  scene.duration = 1;
  scene.frame_rate = scene.samples_per_second = 60;
  scene.truth = {1e-6, resolution, resolution, ""};
  scene.profile = "quick";
  return scene;
}

}  // namespace mb
