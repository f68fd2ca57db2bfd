// What it costs to keep the diagonal of Phi^T C Phi alone where damping couples modes:
//
//   error of dropping = |u_d - u| / |u|,   u: all of C, by complex modes; u_d: its diagonal; elastic part, M norm
//
// and whether complex modes in closed form and adaptive steps of the same system agree.
#include <cmath>
#include <numeric>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "mechanics/system/complex_modes.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr int counts_tried = 5;
constexpr Index most_modes_told = 16;
constexpr double step_tolerance = 1e-8;  // [-] of the adaptive steps

Finding errors_table() {
  return table("damping-coupling", "damping-coupling", "What dropping the coupling by damping costs",
               "Phi^T C Phi whole, by complex modes in closed form, against its diagonal alone, as classical damping "
               "has it: elastic part, M norm over the scene's samples. Coupling: largest |C_ij| / sqrt(C_ii C_jj). "
               "Condition: of the complex modes, which grows where two of them become critical. Closed form against "
               "steps: the same system by adaptive Runge-Kutta steps at rtol 1e-8.",
               {{"modes r", ""},
                {"coupling", "-"},
                {"error of dropping", "-"},
                {"closed form against steps", "-"},
                {"condition", "-"}});
}

Finding modes_table() {
  return table(
      "damping-coupling", "damping-coupling-modes", "Complex modes beside undamped ones",
      "Eigenvalues mu of the damped system in its largest number of modes, slowest first: frequency |mu|/2 pi, "
      "ratio -Re(mu)/|mu|, 1 where it does not swing. Beside each the undamped mode which holds most of its "
      "energy, with the ratio that the diagonal gives it.",
      {{"complex mode", ""},
       {"frequency", "Hz"},
       {"ratio", "-"},
       {"undamped mode", ""},
       {"share of its energy", "-"},
       {"undamped frequency", "Hz"},
       {"ratio by the diagonal", "-"}});
}

MatrixXd damping_matrix(const System& reduced) {
  MatrixXd C(reduced.M.rows(), reduced.M.rows());
  for (Index j = 0; j < C.cols(); ++j) C.col(j) = apply_damping(reduced, VectorXd::Unit(C.rows(), j));
  return C;
}

double largest_coupling(const MatrixXd& C) {
  double largest = 0;
  for (Index i = 0; i < C.rows(); ++i)
    for (Index j = 0; j < i; ++j)
      if (const double scale = std::sqrt(C(i, i) * C(j, j)); scale > 0)
        largest = std::max(largest, std::abs(C(i, j)) / scale);
  return largest;
}

System with_diagonal_alone(const System& reduced, const MatrixXd& C) {
  System diagonal = reduced;
  diagonal.damping = {};
  diagonal.modal_damping = {MatrixXd::Identity(C.rows(), C.cols()), C.diagonal()};
  return diagonal;
}

MatrixXd displacements(const Integrator& integrator, const System& system, const Scene& scene) {
  Settings settings;
  settings.relative_tolerance = step_tolerance;
  settings.load_tolerance = scene.study.load_tolerance;
  const States states = integrator.prepare(system, settings, scene.duration)->run(sample_times(scene));
  if (states.status != Status::ok)
    throw std::runtime_error(std::string("damping-coupling: ") + integrator.name + ": " + to_string(states.status));
  return states.u;
}

void add_modes(Finding& found, const VectorXd& omega, const MatrixXd& C, const ComplexModes& modes) {
  Index told = 0;
  for (Index j = 0; j < modes.mu.size() && told < most_modes_told; ++j) {
    const std::complex<double> mu = modes.mu[j];
    if (mu.imag() < 0) continue;  // the other of a pair
    const auto X = modes.X.col(j);
    const VectorXd energy = X.head(omega.size()).cwiseAbs2() + X.tail(omega.size()).cwiseAbs2();
    Index i = 0;
    const double share = energy.maxCoeff(&i) / energy.sum();
    found.rows.push_back({count(++told), std::abs(mu) / (2 * pi), -mu.real() / std::abs(mu), count(i + 1), share,
                          omega[i] / (2 * pi), C(i, i) / (2 * omega[i])});
  }
}

}  // namespace

std::vector<Finding> coupled_damping(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const std::vector<int> counts = few(mode_counts(context), counts_tried);
  const ModalBody body = modal_body(context, counts.back());
  Finding errors = errors_table(), of_modes = modes_table();
  for (const int r : counts) {
    const Modes kept = leading(body.modes, r);
    const System reduced = project(body.system, kept);
    const MatrixXd C = damping_matrix(reduced);
    const VectorXd omega = kept.omega;
    const ComplexModes modes = complex_modes(omega, C);
    const Integrator& closed = context.catalogue.integrator("exact");
    const MatrixXd u = displacements(closed, reduced, scene);
    const MatrixXd dropped = displacements(closed, with_diagonal_alone(reduced, C), scene);
    const MatrixXd stepped = displacements(context.catalogue.integrator("sundials"), reduced, scene);
    errors.rows.push_back({count(kept.size()), largest_coupling(C), (dropped - u).norm() / u.norm(),
                           (stepped - u).norm() / u.norm(), modes.condition});
    if (r == counts.back()) add_modes(of_modes, omega, C, modes);
  }
  return {errors, of_modes};
}

}  // namespace mb
