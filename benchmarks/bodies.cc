#include "benchmarks/bodies.h"

#include "cases/scene/one_body.h"
#include "reference/full_model.h"

namespace mb {

Scene cylinder_scene(int n_splits) {
  constexpr double mu = 1, nu = 0.3;
  return one_body(Cylinder{0.5, 2}, {2 * mu * (1 + nu), nu, 1}, {2, {n_splits, 2 * n_splits}});
}

std::shared_ptr<const FullModel> cylinder(int n_splits) {
  const Scene scene = cylinder_scene(n_splits);
  return full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
}

}  // namespace mb
