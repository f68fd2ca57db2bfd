#include "cases/exact/rod_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/exact/fit.h"

namespace mb {
namespace {

bool is_end(const std::string& face) { return face == "z-min" || face == "z-max"; }

// An end may be held by anything that stops it along z; lateral faces may slide, which nu = 0 does not notice.
void check_support(const Support& support, const std::string& loaded, Misfit& misfit) {
  const std::string& face = support.patch.face;
  const bool holds = support.kind == Support::Kind::fixed || support.kind == Support::Kind::sliding;
  const bool fits = face != loaded && (is_end(face) ? holds : support.kind == Support::Kind::sliding);
  misfit.require(fits && !support.patch.disc,
                 fmt::format("the support of {} is none that a rod in one dimension has", face));
}

void check_traction(const Traction& traction, Misfit& misfit) {
  misfit.require(is_end(traction.patch.face),
                 fmt::format("the load acts on {}, not on z-min or z-max", traction.patch.face));
  misfit.require(traction.traction[0] == 0 && traction.traction[1] == 0, "the traction is not along z");
}

std::string problem(const Scene& scene) {
  Misfit misfit = one_loaded_undamped_body(scene);
  if (!misfit.empty()) return misfit.text();
  const Body& body = scene.bodies[0];
  const Traction& traction = scene.loads[0].tractions[0];
  misfit.require(std::holds_alternative<Box>(body.shape), "the body is not a box");
  misfit.require(body.material.poissons_ratio == 0,
                 fmt::format("Poisson's ratio is {}, not 0", body.material.poissons_ratio));
  misfit.require(std::holds_alternative<Step>(scene.loads[0].history), "the history is not a step");
  check_traction(traction, misfit);
  for (const Support& support : body.supports) check_support(support, traction.patch.face, misfit);
  return misfit.text();
}

// How the rod lies in the body's frame: x = L/2 + sign z.
struct Placed {
  RodStep rod;
  double sign;   // [-] of z at the loaded end
  double start;  // [s] of the step; one before t = 0 finds the body at rest then
};

Placed placed(const Scene& scene) {
  const Body& body = scene.bodies[0];
  const Traction& traction = scene.loads[0].tractions[0];
  const auto& step = std::get<Step>(scene.loads[0].history);
  const double sign = traction.patch.face == "z-max" ? 1 : -1;
  const bool is_held = std::any_of(body.supports.begin(), body.supports.end(),
                                   [](const Support& support) { return is_end(support.patch.face); });
  return {{std::get<Box>(body.shape).size[2], body.material.youngs_modulus, body.material.density,
           step.amplitude * (sign * traction.traction[2] - traction.pressure), is_held},
          sign,
          std::max(step.start, 0.0)};
}

Trajectory at(const Scene& scene, const EvaluationPoints& points, const VectorXd& t) {
  const auto [rod, sign, start] = placed(scene);
  const Matrix3Xd all = points.all();
  BodyTrajectory body{MatrixXd::Zero(3 * all.cols(), t.size()), MatrixXd::Zero(6 * points.n_strained(), t.size())};
  for (Index j = 0; j < t.size(); ++j)
    for (Index p = 0; p < all.cols(); ++p) {
      const RodState state = rod_state(rod, rod.length / 2 + sign * all(2, p), t[j] - start);
      body.displacement(3 * p + 2, j) = sign * state.u;
      if (const Index e = points.strained(p); e >= 0) body.strain(6 * e + 2, j) = state.strain;
    }
  return {t, {body}, {}, Status::ok};
}

}  // namespace

// Folded into one period of the elastic motion, 4L/c held and 2L/c free, so that long runs lose no digits; a free rod
// meanwhile gains speed at the rate tau/(rho L).
RodState rod_state(const RodStep& rod, double x, double t) {
  const double c = std::sqrt(rod.youngs_modulus / rod.density), s = rod.is_held ? -1 : 1;
  const double period = (rod.is_held ? 4 : 2) * rod.length / c;
  const double n_periods = std::floor(t / period), local = t - n_periods * period;
  if (t < 0) return {0, 0};
  RodState state{0, 0};
  double weight = rod.traction / rod.youngs_modulus;  // of reflection m: (tau/E) s^m
  for (int m = 0; m < 3; ++m, weight *= s) {          // c t <= 4 L: fronts up to (2m + 1) L - x = 4 L
    const double front = c * local - (2 * m + 1) * rod.length, towards = front + x, back = front - x;
    state.u += weight * (std::max(towards, 0.0) + s * std::max(back, 0.0));
    state.strain += weight * ((towards >= 0 ? 1 : 0) - s * (back >= 0 ? 1 : 0));
  }
  if (rod.is_held) return state;
  const double acceleration = rod.traction / (rod.density * rod.length), before = n_periods * period;
  state.u += acceleration * before * (local + before / 2);
  return state;
}

ExactSolution rod_step() {
  return {"rod-step",
          "box along z, nu = 0, a step of axial traction on one end, the other held or free: d'Alembert's waves",
          "Graff 1975, Wave Motion in Elastic Solids, sect. 2.3",
          problem,
          at,
          1e-12};  // rounding: of c t - x in long runs
}

}  // namespace mb
