// What every linear method, full or reduced, does once its system is made:
//
//   u(points, t) = U q(t) + U_s s(t),   q from the stepper; U sparse for a mesh, dense for a basis; U_s corrects
//   statically
#pragma once

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

// modes_used: elastic modes of the basis, -1 for full order. A failed stepper's status is the trajectory's.
std::unique_ptr<Prepared> prepare_linear(std::vector<LinearBody> bodies, const Integrator& integrator,
                                         const Settings& settings, double duration, int modes_used);

}  // namespace mb
