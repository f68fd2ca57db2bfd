#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "mechanics/system/exact.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int n_modes = 40;

// What the scene states for elastic mode i (from 0): its ratio, or Rayleigh's zeta = alpha/(2 omega) + beta omega/2.
double asked(const Body& body, Index i, double omega) {
  if (body.damping_ratios.empty()) return body.damping.alpha / (2 * omega) + body.damping.beta * omega / 2;
  const auto mode = static_cast<size_t>(i);
  return mode < body.damping_ratios.size() ? body.damping_ratios[mode] : 0;
}

// From the free decay of mode i of the reduced system, let go from rest: over one damped period it shrinks to
// e^(-2 pi zeta / sqrt(1 - zeta^2)). NaN where it does not swing.
double by_decay(System reduced, Index i, double omega, double expected) {
  if (!(expected < 0.99)) return nan;
  reduced.F.resize(reduced.M.rows(), 0);
  reduced.s.clear();
  reduced.u0 = VectorXd::Unit(reduced.M.rows(), i);
  reduced.v0 = VectorXd::Zero(reduced.M.rows());
  const double period = 2 * pi / (omega * std::sqrt(1 - expected * expected));
  const double left = exact(reduced, period)->run(VectorXd::Constant(1, period)).u(i, 0);
  const double decrement = -std::log(left);
  return left > 0 ? decrement / std::hypot(2 * pi, decrement) : nan;
}

// Largest |C_ij| / sqrt(C_ii C_jj), j != i, of Phi^T C Phi: 0 where damping leaves the modes uncoupled.
double coupling(const MatrixXd& C, Index i) {
  double largest = 0;
  for (Index j = 0; j < C.cols(); ++j)
    if (const double scale = std::sqrt(C(i, i) * C(j, j)); j != i && scale > 0)
      largest = std::max(largest, std::abs(C(i, j)) / scale);
  return largest;
}

}  // namespace

std::vector<Finding> achieved_damping(const AnalysisContext& context) {
  const Body& scene_body = context.scene->bodies.front();
  const ModalBody body = modal_body(context, n_modes);
  const Index n_rigid = body.modes.n_rigid, n = body.modes.size() - n_rigid;
  const System reduced = project(body.system, body.modes);
  const Modes unit{n_rigid, body.modes.omega, MatrixXd::Identity(body.modes.size(), body.modes.size()), {}, 0};
  const VectorXd of_full = damping_ratios(body.system, body.modes), of_reduced = damping_ratios(reduced, unit);
  MatrixXd C(n, n);
  for (Index i = 0; i < n; ++i)
    C.row(i) = body.modes.Phi.rightCols(n).transpose() * apply_damping(body.system, body.modes.Phi.col(n_rigid + i));
  Finding found = table(
      "damping", "damping", "Damping ratios asked for and achieved",
      "Asked: the scene's ratio of the mode, or Rayleigh's alpha/(2 omega) + beta omega/2. Full: phi^T C phi/(2 omega) "
      "by "
      "the damping operator of the full system; reduced: the same of the reduced one. By decay: logarithmic decrement "
      "over one period of the mode let go from rest, in closed form. Coupling: largest |C_ij|/sqrt(C_ii C_jj) with the "
      "other modes of the table, 0 where they stay uncoupled.",
      {{"mode", ""},
       {"frequency", "Hz"},
       {"zeta asked", "-"},
       {"zeta full", "-"},
       {"zeta reduced", "-"},
       {"zeta by decay", "-"},
       {"coupling", "-"}});
  for (Index i = 0; i < n; ++i) {
    const double omega = body.modes.omega(n_rigid + i);
    found.rows.push_back({count(i + 1), omega / (2 * pi), asked(scene_body, i, omega), of_full(i), of_reduced(i),
                          by_decay(reduced, n_rigid + i, omega, of_reduced(i)), coupling(C, i)});
  }
  return {found};
}

}  // namespace mb
