// Largest and smallest value of every probe's signal, by the parabola through the largest sample and its neighbours,
// and the static displacement under the loads of the last moment (inertia relief where the body is free).
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "mechanics/system/static_response.h"
#include "modal/bases/eigenmodes.h"

namespace mb {

namespace {

struct Extreme {
  double value, time;  // [m], [s]
};

// sign +1: the largest, -1: the smallest.
Extreme extreme(const VectorXd& t, const VectorXd& signal, double sign) {
  Index k = 0;
  (sign * signal).maxCoeff(&k);
  if (k == 0 || k + 1 == signal.size()) return {signal[k], t[k]};
  const double slope = 0.5 * (signal[k + 1] - signal[k - 1]);
  const double curvature = signal[k + 1] - 2 * signal[k] + signal[k - 1];
  if (curvature == 0) return {signal[k], t[k]};
  const double x = -slope / curvature;  // in steps, within half a step of the sample
  return {signal[k] + 0.5 * slope * x, t[k] + x * (t[k + 1] - t[k])};
}

VectorXd signal_of(const Trajectory& trajectory, const EvaluationPoints& points, Index probe,
                   const Vector3d& direction) {
  const Index point = points.volume.points.cols() + points.surface.points.cols() + probe;
  return trajectory.bodies.front().displacement.middleRows(3 * point, 3).transpose() * direction;
}

double static_value(const AnalysisContext& context, const Probe& probe) {
  const Scene& scene = *context.scene;
  const FullModel& full = *context.model(scene.bodies.front().resolution).bodies.front().full;
  const System& system = full.system();
  const VectorXd F = system.F * LoadFactors(system)(scene.duration);
  const MatrixXd u = inertia_relief(system, shifted_factor(system, physical_shift(scene.bodies.front())), F);
  const VectorXd at = full.displacement_at(Matrix3Xd(probe.point)) * u;
  return probe.direction.dot(at);
}

}  // namespace

std::vector<Finding> probe_extremes(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const EvaluationPoints points = evaluation_points(scene, scene.bodies.front());
  Finding table;
  table.analysis = table.name = "probe-extremes";
  table.title = "Largest and smallest probe values";
  table.note =
      "By the parabola through the extreme sample and its neighbours. Static: displacement under the loads at the end, "
      "body's mesh; a free body in balance with its inertia.";
  table.columns = {{"probe", ""},     {"truth", ""},          {"largest", "m"}, {"at (largest)", "s"},
                   {"smallest", "m"}, {"at (smallest)", "s"}, {"static", "m"},  {"largest/static", "-"}};
  const auto add = [&](size_t p, const char* name, const Trajectory& truth, double at_rest) {
    const VectorXd signal = signal_of(truth, points, static_cast<Index>(p), scene.probes[p].direction);
    const Extreme high = extreme(truth.t, signal, 1), low = extreme(truth.t, signal, -1);
    table.rows.push_back(
        {scene.probes[p].name, name, high.value, high.time, low.value, low.time, at_rest, high.value / at_rest});
  };
  for (size_t p = 0; p < scene.probes.size(); ++p) {
    const double at_rest = static_value(context, scene.probes[p]);
    add(p, "finer", context.truth.finer, at_rest);
    add(p, "same_mesh", context.truth.same_mesh, at_rest);
    if (context.truth.exact) add(p, "exact", *context.truth.exact, at_rest);
  }
  return {table};
}

}  // namespace mb
