// For tests of finite kinematics: bodies, their momenta and the rigid motions that they start with.
#pragma once

#include "cases/scene/one_body.h"
#include "mechanics/system/stored_energy.h"
#include "reference/full_model.h"

namespace mb::testing {

inline Scene finite_body(const Shape& shape, const Material& material, const Resolution& mesh,
                         const Rayleigh& damping = {}) {
  Scene scene = one_body(shape, material, mesh);
  scene.bodies[0].kinematics = Kinematics::finite;
  scene.bodies[0].damping = damping;
  return scene;
}

inline std::shared_ptr<const FullModel> model_of(const Scene& scene) {
  return full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
}

inline System without_energy(System system) {
  system.stored_energy = nullptr;
  return system;
}

// A body without supports: places and sums over its nodes.
struct FreeBody {
  explicit FreeBody(const FullModel& model) : X(model.places()), M(model.system().M), mass(M.sum() / 3) {}

  VectorXd moving(const Vector3d& velocity, const Vector3d& omega) const {  // [m/s] of x = X
    VectorXd v(X.size());
    for (Index i = 0; i < X.size(); i += 3) v.segment<3>(i) = velocity + omega.cross(Vector3d(X.segment<3>(i)));
    return v;
  }
  Vector3d momentum(const VectorXd& v) const {  // [kg m/s]
    return VectorXd(M * v).reshaped(3, v.size() / 3).rowwise().sum();
  }
  Vector3d centroid(const VectorXd& u) const { return momentum(X + u) / mass; }  // [m]
  Vector3d angular_momentum(const VectorXd& u, const VectorXd& v) const {        // [kg m^2/s] about the origin
    const VectorXd x = X + u, p = M * v;
    Vector3d L = Vector3d::Zero();
    for (Index i = 0; i < X.size(); i += 3) L += Vector3d(x.segment<3>(i)).cross(Vector3d(p.segment<3>(i)));
    return L;
  }
  Vector3d spin(const VectorXd& u, const VectorXd& v) const {  // about the centroid
    return angular_momentum(u, v) - centroid(u).cross(momentum(v));
  }

  VectorXd X;  // [m]
  SparseMatrix M;
  double mass;  // [kg]
};

}  // namespace mb::testing
