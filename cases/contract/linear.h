// What every linear method, full or reduced, does once its system is made:
//
//   u(points, t) = U q(t) + U_s s(t),   q from the stepper; U sparse for a mesh, dense for a basis; U_s corrects
//   statically
#pragma once

#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "cases/contract/method.h"

namespace mb {

struct Observation {
  std::variant<SparseMatrix, MatrixXd> of_state;  // values x n
  MatrixXd of_load;                               // values x loads, or empty (0 columns)
};
MatrixXd observe(const Observation& observation, const MatrixXd& q, const MatrixXd& s);  // values x n_t

struct LinearBody {
  System system;
  Observation displacement, strain;
};

// A model reduced to what steppers act on, by whatever basis; independent of the integrator.
struct Reduction {
  std::vector<LinearBody> bodies;
  int modes_used;  // elastic modes of the basis, of the body that uses most; -1 for full order
  // In a scene with contact, or of bodies of finite kinematics: what answers in the place of linear steppers.
  std::function<std::unique_ptr<Prepared>(const Integrator& integrator, const Settings& settings)> in_contact = {};
};

// Every degree of freedom of the mesh: the identity as basis, u = q.
Reduction unreduced(const Model& model);

// A failed stepper's status is the trajectory's. Sampling::shutter > 0 needs an integrator with exact averages.
std::unique_ptr<Prepared> prepare_linear(std::shared_ptr<const Reduction> reduction, const Integrator& integrator,
                                         const Settings& settings, double duration);
std::unique_ptr<Prepared> prepare_linear(std::vector<LinearBody> bodies, const Integrator& integrator,
                                         const Settings& settings, double duration, int modes_used);

// A method whose offline part comes in two: the basis, and what an integrator prepares on it. Who tries several
// integrators or steps on one basis reduces once and charges the time of that to each.
class LinearMethod : public Method {
 public:
  // Reads settings.modes alone, and that only where the method takes modes.
  virtual Reduction reduce(const Model& model, const Settings& settings) const = 0;
  std::unique_ptr<Prepared> prepare(const Model& model, const Settings& settings,
                                    const Integrator& integrator) const final;
};

}  // namespace mb
