#include "harness/analysis/dropped_coupling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace mb {

namespace {

constexpr double step_tolerance = 1e-8;  // [-] of the adaptive steps

System with_diagonal_alone(const System& reduced, const MatrixXd& C) {
  System diagonal = reduced;
  diagonal.damping = {};
  diagonal.modal_damping = {MatrixXd::Identity(C.rows(), C.cols()), C.diagonal()};
  return diagonal;
}

}  // namespace

MatrixXd damping_matrix(const System& reduced) {
  MatrixXd C(reduced.M.rows(), reduced.M.rows());
  for (Index j = 0; j < C.cols(); ++j) C.col(j) = apply_damping(reduced, VectorXd::Unit(C.rows(), j));
  return C;
}

VectorXd couplings(const MatrixXd& C) {
  VectorXd largest = VectorXd::Zero(C.rows());
  if (C.size() == 0) return largest;
  if (!C.allFinite()) return VectorXd::Constant(C.rows(), std::numeric_limits<double>::quiet_NaN());
  const double rounding = 1e-13 * C.cwiseAbs().maxCoeff();
  for (Index i = 0; i < C.rows(); ++i)
    for (Index j = 0; j < C.rows(); ++j)
      if (const double scale = std::sqrt(C(i, i) * C(j, j)); j != i && std::abs(C(i, j)) > rounding && scale > 0)
        largest(i) = std::max(largest(i), std::abs(C(i, j)) / scale);
  return largest;
}

double largest_coupling(const MatrixXd& C) { return C.size() > 0 ? couplings(C).maxCoeff() : 0; }

DroppedCoupling dropped_coupling(const System& reduced, const MatrixXd& damping, const Integrator& closed_form,
                                 const Integrator& steps, const VectorXd& times, double duration,
                                 double load_tolerance) {
  const auto displacements = [&](const Integrator& integrator, const System& system) {
    Settings settings;
    settings.relative_tolerance = step_tolerance;
    settings.load_tolerance = load_tolerance;
    States states = integrator.prepare(system, settings, duration)->run(times);
    if (states.status != Status::ok)
      throw std::runtime_error("damping-coupling: " + integrator.name + ": " + to_string(states.status));
    return states.u;
  };
  const MatrixXd u = displacements(closed_form, reduced);
  const double size = u.norm();
  if (!(size > 0)) throw std::invalid_argument("damping-coupling: nothing moves");
  const MatrixXd dropped = displacements(closed_form, with_diagonal_alone(reduced, damping));
  return {(dropped - u).norm() / size, (displacements(steps, reduced) - u).norm() / size};
}

}  // namespace mb
