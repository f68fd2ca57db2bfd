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

// What the scene states for every elastic mode: its ratio, which the rest of its multiplet shares, or Rayleigh's
// zeta = alpha/(2 omega) + beta omega/2.
VectorXd asked(const Body& body, const VectorXd& omega) {
  VectorXd zeta = body.damping.alpha / 2 * omega.cwiseInverse() + body.damping.beta / 2 * omega;
  const auto n = static_cast<Index>(body.damping_ratios.size());
  for (Index i = 0; i < omega.size(); ++i) {
    const auto lambda = [&](Index k) { return omega(k) * omega(k); };
    if (i < n)
      zeta(i) = body.damping_ratios[static_cast<size_t>(i)];
    else if (n > 0 && lambda(i) - lambda(n - 1) <= multiplet_gap * lambda(i))
      zeta(i) = body.damping_ratios.back();
  }
  return zeta;
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
  const VectorXd of_scene = asked(scene_body, body.modes.omega.tail(n));
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
    found.rows.push_back({count(i + 1), omega / (2 * pi), of_scene(i), of_full(i), of_reduced(i),
                          by_decay(reduced, n_rigid + i, omega, of_reduced(i)), coupling(C, i)});
  }
  return {found};
}

}  // namespace mb
