#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "harness/analysis/analyses.h"
#include "harness/analysis/dropped_coupling.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/step_damping.h"
#include "mechanics/system/exact.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int n_modes = 40, most_kept = 32, most_stepped_modes = 8;

// What the scene states for every elastic mode: its ratio, which the rest of its multiplet shares, or Rayleigh's
// zeta = alpha/(2 omega) + beta omega/2.
VectorXd asked(const Body& body, const VectorXd& omega, double lambda_max) {
  VectorXd zeta = body.damping.alpha / 2 * omega.cwiseInverse() + body.damping.beta / 2 * omega;
  const auto n = static_cast<Index>(body.damping_ratios.size());
  for (Index i = 0; i < omega.size(); ++i) {
    const auto lambda = [&](Index k) { return omega(k) * omega(k); };
    if (i < n)
      zeta(i) = body.damping_ratios[static_cast<size_t>(i)];
    else if (n > 0 && are_one_multiplet(lambda(n - 1), lambda(i), lambda_max))
      zeta(i) = body.damping_ratios.back();
  }
  return zeta;
}

// From the free decay of mode i of the reduced system, let go from rest: over one damped period it shrinks to
// e^(-2 pi zeta / sqrt(1 - zeta^2)). NaN where it does not swing.
double by_decay(const System& reduced, Index i, double omega, double expected) {
  if (!(expected < 0.99)) return nan;
  const System alone = let_go(reduced, VectorXd::Unit(reduced.M.rows(), i));
  const double period = 2 * pi / (omega * std::sqrt(1 - expected * expected));
  const double left = exact(alone, period)->run(VectorXd::Constant(1, period)).u(i, 0);
  const double decrement = -std::log(left);
  return left > 0 ? decrement / std::hypot(2 * pi, decrement) : nan;
}

// What [[study.stepping]] steps with, where a method of it keeps modes, and the most that one keeps.
struct Steps {
  std::vector<std::pair<std::string, double>> all;  // integrator, step [s]; in the order of the study, each once
  int most_modes = 0;
};
Steps steps_of_modes(const AnalysisContext& context) {
  Steps steps;
  for (const Stepping& stepping : context.scene->study.steppings) {
    const auto keeps_modes = [&](const std::string& name) { return context.catalogue.method(name).takes_modes(); };
    if (stepping.modes.empty() || std::none_of(stepping.methods.begin(), stepping.methods.end(), keeps_modes)) continue;
    steps.most_modes = std::max(steps.most_modes, *std::max_element(stepping.modes.begin(), stepping.modes.end()));
    for (const double dt : stepping.time_steps) {
      const std::pair step(stepping.integrator, dt);
      if (std::find(steps.all.begin(), steps.all.end(), step) == steps.all.end()) steps.all.push_back(step);
    }
  }
  return steps;
}

Finding steps_table() {
  return table(
      "damping", "damping-of-steps", "Damping ratios that the study's integrators and steps achieve",
      "Scheme: -ln|lambda| / |ln lambda|, lambda the eigenvalue of largest modulus of the integrator's recurrence "
      "for this mode, |ln lambda| the phase and decay of one step: the ratio of an exact step. Run: the same from "
      "the displacements of the integrator itself, let go from rest in the mode with all others kept. Of an answer "
      "that creeps -(ln lambda_1 + ln lambda_2)/(2 sqrt(ln lambda_1 ln lambda_2)). Negative: the mode grows where it "
      "ought to decay. Not applicable where one eigenvalue grows and one decays, where both are of the same size and "
      "of either sign, and to runs where one is gone within a sample. Difference: scheme less asked. At most eight "
      "of the modes kept, spread over them; integrators of fixed step. Bars: twice the distance to the same on the "
      "finer mesh of the case.",
      {{"mode", ""},
       {"frequency", "Hz"},
       {"zeta asked", "-"},
       {"integrator", ""},
       {"dt", "s"},
       {"omega dt", "-"},
       {"zeta of scheme", "-"},
       {"zeta of run", "-"},
       {"difference", "-"}});
}

Finding ratios_table() {
  return table(
      "damping", "damping", "Damping ratios asked for and achieved",
      "Asked: the scene's ratio of the mode, or Rayleigh's alpha/(2 omega) + beta omega/2. Full: phi^T C phi/(2 omega) "
      "by the damping operator of the full system; reduced: the same of the reduced one. By decay: logarithmic "
      "decrement over one period of the mode let go from rest, in closed form: these must agree, and show that "
      "reduction changes no ratio. What steps make of it stands in table damping-of-steps. Coupling: largest "
      "|C_ij|/sqrt(C_ii C_jj) with the other modes of the table, 0 where they stay uncoupled to 1e-13 of C's largest "
      "entry. Bars: twice the distance to the same on the finer mesh of the case.",
      {{"mode", ""},
       {"frequency", "Hz"},
       {"zeta asked", "-"},
       {"zeta full", "-"},
       {"zeta reduced", "-"},
       {"zeta by decay", "-"},
       {"coupling", "-"}});
}

// zeta: of the reduced system, as steps meet it; asked: of the scene.
Finding damping_of_steps(const AnalysisContext& context, const Steps& steps, const System& reduced,
                         const VectorXd& omega, const VectorXd& zeta, const VectorXd& asked) {
  Finding found = steps_table();
  std::vector<int> kept(static_cast<size_t>(omega.size()));
  std::iota(kept.begin(), kept.end(), 0);
  for (const int i : few(kept, most_stepped_modes))
    for (const auto& [name, dt] : steps.all) {
      const VectorXd e = VectorXd::Unit(reduced.M.rows(), reduced.R.cols() + i);
      const Scheme* scheme = scheme_of(name, reduced);
      const double by_scheme = scheme ? step_damping(*scheme, omega(i) * dt, std::max(0.0, zeta(i))) : nan;
      const double by_run = run_damping(reduced, {omega(i), zeta(i), e, e}, context.catalogue.integrator(name), dt);
      found.rows.push_back({count(i + 1), omega(i) / (2 * pi), asked(i), name, dt, omega(i) * dt, by_scheme, by_run,
                            by_scheme - asked(i)});
    }
  return found;
}

}  // namespace

std::vector<Finding> achieved_damping(const AnalysisContext& context) {
  const Body& scene_body = context.scene->bodies.front();
  const ModalBody body = modal_body(context, n_modes);
  const Index n_rigid = body.modes.n_rigid, n = body.modes.size() - n_rigid;
  const System reduced = project(body.system, body.modes);
  const Modes unit{n_rigid, body.modes.omega, MatrixXd::Identity(body.modes.size(), body.modes.size()), {}, 0};
  const VectorXd of_full = damping_ratios(body.system, body.modes), of_reduced = damping_ratios(reduced, unit);
  const VectorXd of_scene = asked(scene_body, body.modes.omega.tail(n), body.modes.lambda_max);
  MatrixXd C(n, n);
  for (Index i = 0; i < n; ++i)
    C.row(i) = body.modes.Phi.rightCols(n).transpose() * apply_damping(body.system, body.modes.Phi.col(n_rigid + i));
  const VectorXd coupling = couplings(C);
  Finding found = ratios_table();
  for (Index i = 0; i < n; ++i) {
    const double omega = body.modes.omega(n_rigid + i);
    found.rows.push_back({count(i + 1), omega / (2 * pi), of_scene(i), of_full(i), of_reduced(i),
                          by_decay(reduced, n_rigid + i, omega, of_reduced(i)), coupling(i)});
  }
  const Steps steps = steps_of_modes(context);
  if (steps.all.empty()) return {found};
  const Modes kept = leading(body.modes, std::min(steps.most_modes, most_kept));
  const Index n_kept = kept.size() - n_rigid;
  return {found, damping_of_steps(context, steps, project(body.system, kept), kept.omega.tail(n_kept),
                                  of_reduced.head(n_kept), of_scene.head(n_kept))};
}

}  // namespace mb
