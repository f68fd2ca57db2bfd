// Largest and smallest value of every probe's signal, by the parabola through the largest sample and its neighbours,
// and the static displacement under the loads of the last moment (inertia relief where the body is free).
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
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
  const FullModel& full = *context.model(own_meshes(scene)).bodies.front().full;
  const System& system = full.system();
  const VectorXd F = system.F * LoadFactors(system)(scene.duration);
  const MatrixXd u = inertia_relief(system, shifted_factor(system, physical_shift(scene.bodies.front())), F);
  const VectorXd at = full.displacement_at(Matrix3Xd(probe.point)) * u;
  return probe.direction.dot(at);
}

// Of the last row: values are off by what the series is, of the largest displacement; a time by how far an extreme of
// that height may be from the next sample.
void bar_exact(Finding& table, const TruthSet& truth) {
  const double off = truth.exact_bar * truth.exact->bodies.front().displacement.cwiseAbs().maxCoeff();
  const double sample = truth.exact->t[1] - truth.exact->t[0];
  bar_last_row(table, {{"largest", off}, {"at (largest)", sample}, {"smallest", off}, {"at (smallest)", sample}});
}

}  // namespace

std::vector<Finding> probe_extremes(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const EvaluationPoints points = evaluation_points(scene, scene.bodies.front());
  Finding table;
  table.analysis = table.name = "probe-extremes";
  table.title = "Largest and smallest probe values";
  table.note =
      "By the parabola through the extreme sample and its neighbours; of a closed form with the bar of its series, of "
      "times with a sample. Static: displacement under the loads at the end, "
      "body's mesh; a free body in balance with its inertia; its bar, twice the distance to that of the finer mesh of "
      "the case. Over it: the extreme on its side.";
  table.columns = {{"probe", ""},     {"truth", ""},          {"largest", "m"}, {"at (largest)", "s"},
                   {"smallest", "m"}, {"at (smallest)", "s"}, {"static", "m"},  {"largest/static", "-"}};
  const auto add = [&](const Probe& probe, Index place, const char* name, const Trajectory& truth, double at_rest) {
    const VectorXd signal = signal_of(truth, points, place, probe.direction);
    const Extreme high = extreme(truth.t, signal, 1), low = extreme(truth.t, signal, -1);
    const double same_side = at_rest > 0 ? high.value : low.value;
    table.rows.push_back({probe.name, name, high.value, high.time, low.value, low.time, at_rest,
                          at_rest != 0 ? same_side / at_rest : std::numeric_limits<double>::quiet_NaN()});
  };
  Index place = 0;  // among the probes of the first body
  for (const Probe& probe : scene.probes) {
    if (probe.body != scene.bodies.front().name) continue;
    const double at_rest = static_value(context, probe);
    add(probe, place, "finer", context.truth.finer, at_rest);
    add(probe, place, "same_mesh", context.truth.same_mesh, at_rest);
    if (context.truth.exact) {
      add(probe, place, "exact", *context.truth.exact, at_rest);
      bar_exact(table, context.truth);
    }
    ++place;
  }
  return {table};
}

}  // namespace mb
