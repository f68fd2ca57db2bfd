#include "harness/metrics/finite_metrics.h"

#include <algorithm>
#include <limits>

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// [s] From then on nothing does work on the bodies but damping.
double free_from(const Scene& scene) {
  double t = scene.contacts.empty() && scene.gravity.isZero(0) ? 0 : infinity;
  for (const Load& load : scene.loads) t = std::max(t, end(load.history, scene.duration));
  for (const Body& body : scene.bodies)
    if (std::ranges::any_of(body.supports, [](const Support& s) { return s.drive.has_value(); })) return infinity;
  return t;
}

double of_answer(const Trajectory& answer, const Trajectory&, const MetricContext& context) {
  return free_gain(answer, context.scene);
}

}  // namespace

double free_gain(const Trajectory& answer, const Scene& scene) {
  VectorXd E = VectorXd::Zero(answer.t.size());
  for (const BodyTrajectory& body : answer.bodies) {
    if (body.energy.size() != E.size()) return nan;
    E += body.energy;
  }
  const auto first = std::ranges::lower_bound(answer.t, free_from(scene));
  const auto n_before = static_cast<Index>(first - answer.t.begin());
  if (n_before + 1 >= E.size() || !E.allFinite()) return nan;
  const double until_then = E.head(n_before + 1).maxCoeff();
  if (!(until_then > 0)) return nan;
  return (E.tail(E.size() - n_before).maxCoeff() - E[n_before]) / until_then;
}

std::vector<Metric> finite_metrics() {
  Metric gain{"free-gain",
              "-",
              "Largest gain of kinetic and stored energy once the last load has ended, by the largest until then; what "
              "damping takes hides as much; of "
              "full order of finite kinematics, without contact and weight.",
              false,
              false,
              false,
              &of_answer};
  gain.finite_only = gain.of_answer_alone = true;
  return {gain};
}

}  // namespace mb
