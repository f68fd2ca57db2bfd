#include "modal/methods/projection.h"

#include "modal/bases/eigenmodes.h"

namespace mb {
namespace {

SparseMatrix diagonal(const VectorXd& d) {
  SparseMatrix D(d.size(), d.size());  // may be 0 x 0: a supported body with no elastic mode
  D.reserve(d.size());
  for (Index i = 0; i < d.size(); ++i) D.insert(i, i) = d(i);
  return D;
}

Observation observe_modes(const SparseMatrix& at_points, const Modes& modes, const MatrixXd& correction) {
  return {.of_state = MatrixXd(at_points * modes.Phi), .of_load = MatrixXd(at_points * correction)};
}

}  // namespace

System project(const System& system, const Modes& modes) {
  const Index size = modes.size();
  const VectorXd lambda = modes.omega.array().square();
  System reduced;
  reduced.M = diagonal(VectorXd::Ones(size));
  reduced.K = diagonal(lambda);
  reduced.damping = system.damping;
  reduced.R = MatrixXd::Identity(size, modes.n_rigid);
  reduced.F = modes.Phi.transpose() * system.F;
  reduced.s = system.s;
  reduced.u0 = modes.Phi.transpose() * (system.M * system.u0);
  reduced.v0 = modes.Phi.transpose() * (system.M * system.v0);
  return reduced;
}

MatrixXd residual_flexibility(const System& system, const Modes& modes, const MatrixXd& G_F) {
  const Index n_elastic = modes.size() - modes.n_rigid;
  const auto Phi = modes.Phi.rightCols(n_elastic);
  const VectorXd flexibility = modes.omega.tail(n_elastic).array().square().inverse();
  return G_F - Phi * (flexibility.asDiagonal() * (Phi.transpose() * system.F));
}

ReducedBody reduce(const BodyModel& model, const ShiftedFactor& shifted, int n_modes, bool corrected) {
  const System& system = model.full->system();
  const Modes modes = lowest_modes(system, n_modes, shifted);
  const MatrixXd correction = corrected ? residual_flexibility(system, modes, inertia_relief(system, shifted, system.F))
                                        : MatrixXd(system.F.rows(), 0);
  return {.body = {.system = project(system, modes),
                   .displacement = observe_modes(model.displacement, modes, correction),
                   .strain = observe_modes(model.strain, modes, correction)},
          .n_elastic = static_cast<int>(modes.size() - modes.n_rigid)};
}

}  // namespace mb
