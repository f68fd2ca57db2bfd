// For tests: the static answer of one loaded body, K u = F summed over its loads (inertia relief where it is free), as
// displacements and strains at the evaluation points of its shape.
#pragma once

#include "cases/scene/one_body.h"
#include "mechanics/system/static_response.h"
#include "reference/full_model.h"

namespace mb::testing {

inline Support support(Support::Kind kind, const Patch& patch) { return {kind, patch, std::nullopt}; }
inline Patch face(const std::string& name) { return {name, std::nullopt}; }

// traction t and pressure p [Pa] on the whole face of the only body
inline void load(Scene& scene, const std::string& name, const Vector3d& t, double p = 0) {
  if (scene.loads.empty()) scene.loads.push_back({"load", Step{}, {}});
  scene.loads[0].tractions.push_back({"body", face(name), t, p});
}

struct StaticAnswer {
  Matrix3Xd points;        // [m] volume, then surface
  Matrix3Xd displacement;  // [m] at the points
  MatrixXd strain;         // [-] 6 x volume points
};

inline VectorXd static_solution(const Scene& scene, const System& s) {
  const Body& body = scene.bodies[0];
  const double l = extent(body.shape), shift = -0.01 * body.material.youngs_modulus / (body.material.density * l * l);
  return inertia_relief(s, shifted_factor(s, shift), s.F).rowwise().sum();
}

inline StaticAnswer static_answer(const Scene& scene) {
  const Body& body = scene.bodies[0];
  const auto model = full_model(scene, body, body.resolution);
  const EvaluationPoints points = evaluation_points(scene, body);
  const VectorXd u = static_solution(scene, model->system());
  StaticAnswer answer{points.all(), {}, {}};
  answer.displacement = (model->displacement_at(answer.points) * u).reshaped(3, answer.points.cols());
  answer.strain = (model->strain_at(points.volume.points) * u).reshaped(6, points.volume.points.cols());
  return answer;
}

}  // namespace mb::testing
