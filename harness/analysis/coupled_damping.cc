// Damping that couples modes: what dropping the coupling costs (dropped_coupling.h), and the complex modes.
#include <cmath>

#include "harness/analysis/analyses.h"
#include "harness/analysis/dropped_coupling.h"
#include "harness/analysis/modal_body.h"
#include "mechanics/system/complex_modes.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr int counts_tried = 5;
constexpr Index most_modes_told = 16;

Finding errors_table() {
  return table("damping-coupling", "damping-coupling", "What dropping the coupling by damping costs",
               "Phi^T C Phi whole, by complex modes in closed form, against its diagonal alone, as classical damping "
               "has it: elastic part, M norm over the scene's samples. Coupling: largest |C_ij| / sqrt(C_ii C_jj). "
               "Condition: of the complex modes, which grows where two of them become critical. Closed form against "
               "steps: the same system by adaptive Runge-Kutta steps at rtol 1e-8. Bars: twice the distance to the "
               "same on the finer mesh of the case.",
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
      "energy, with the ratio that the diagonal gives it. Bars: twice the distance to the same on the finer mesh of "
      "the case.",
      {{"complex mode", ""},
       {"frequency", "Hz"},
       {"ratio", "-"},
       {"undamped mode", ""},
       {"share of its energy", "-"},
       {"undamped frequency", "Hz"},
       {"ratio by the diagonal", "-"}});
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
    const DroppedCoupling dropped =
        dropped_coupling(reduced, C, context.catalogue.integrator("exact"), context.catalogue.integrator("sundials"),
                         sample_times(scene), scene.duration, scene.study.load_tolerance);
    errors.rows.push_back(
        {count(kept.size()), largest_coupling(C), dropped.error, dropped.closed_form_against_steps, modes.condition});
    if (r == counts.back()) add_modes(of_modes, omega, C, modes);
  }
  return {errors, of_modes};
}

}  // namespace mb
