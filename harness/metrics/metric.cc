#include "harness/metrics/metric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void expect(bool condition, const char* fault) {
  if (!condition) throw std::invalid_argument(fault);
}

void expect_body(const Trajectory& trajectory, const MetricContext& context) {
  expect(static_cast<Index>(trajectory.bodies.size()) == static_cast<Index>(context.scene.bodies.size()),
         "metric: an answer has another number of bodies than its scene");
  const BodyTrajectory& body = trajectory.bodies[static_cast<std::size_t>(context.body)];
  expect(body.displacement.rows() == 3 * context.points.size() &&
             (body.displacement.cols() == 0 || body.displacement.cols() == trajectory.t.size()),
         "metric: an answer has other points or times than its context");
  expect(body.strain.cols() == 0 ||
             (body.strain.rows() == 6 * context.points.n_strained() && body.strain.cols() == trajectory.t.size()),
         "metric: an answer has strains at other points or times than its context");
}

void expect_same_times(const VectorXd& a, const VectorXd& b) {
  expect(a.size() == b.size() && a.size() > 0, "metric: the answers have different numbers of times, or none");
  const Index n = a.size();
  const double step = n > 1 ? (b(n - 1) - b(0)) / static_cast<double>(n - 1) : std::abs(b(0));
  // Times are sums and quotients of the scene's numbers: they differ by rounding, never by a billionth of a step.
  expect((a - b).cwiseAbs().maxCoeff() <= 1e-9 * step, "metric: the answers have different times");
}

void expect_context(const Metric& metric, const MetricContext& context) {
  const Scene& scene = context.scene;
  expect(context.body >= 0 && context.body < static_cast<Index>(scene.bodies.size()), "metric: no such body");
  if (!metric.per_probe) return;
  expect(context.probe >= 0 && context.probe < static_cast<Index>(scene.probes.size()), "metric: no such probe");
  const Probe& probe = scene.probes[static_cast<std::size_t>(context.probe)];
  expect(probe.body == scene.bodies[static_cast<std::size_t>(context.body)].name, "metric: probe of another body");
}

// Closed forms of contact alone say nothing of how the body deforms.
bool says_nothing(const Metric& metric, const Trajectory& trajectory, const MetricContext& context) {
  const BodyTrajectory& body = trajectory.bodies[static_cast<std::size_t>(context.body)];
  return !metric.contact_only && body.displacement.cols() < trajectory.t.size();
}

}  // namespace

const Metric& metric(const std::string& name) {
  const std::vector<Metric>& all = metric_catalogue();
  const auto found = std::ranges::find(all, name, &Metric::name);
  if (found == all.end()) throw std::out_of_range("no metric '" + name + "'");
  return *found;
}

// By the sum, which runs at the speed of memory: what is not finite stays so in it. Finite values whose sum is not
// could not be squared either.
bool is_finite(const Trajectory& trajectory, Index body) {
  if (body < 0 || body >= static_cast<Index>(trajectory.bodies.size())) return false;
  const BodyTrajectory& of = trajectory.bodies[static_cast<std::size_t>(body)];
  return std::isfinite(of.displacement.sum()) && std::isfinite(of.strain.sum());
}

Mark mark(const Metric& metric, const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return mark(metric, answer, truth, context, {is_finite(answer, context.body), is_finite(truth, context.body)});
}

Mark mark(const Metric& metric, const Trajectory& answer, const Trajectory& truth, const MetricContext& context,
          const Finite& finite) {
  expect_context(metric, context);
  expect_body(truth, context);
  if (truth.status != Status::ok || !finite.truth) return {nan, "failed: the truth is not finite or not whole"};
  if (!metric.of_truth_alone) {
    if (answer.status != Status::ok) return {nan, to_string(answer.status)};
    expect_body(answer, context);
    expect_same_times(answer.t, truth.t);
    if (!finite.answer) return {nan, "not_finite"};
  }
  if (metric.free_only && !context.free) return {nan, "undefined: the body is not free"};
  if (says_nothing(metric, truth, context) || (!metric.of_truth_alone && says_nothing(metric, answer, context)))
    return {nan, "undefined: answer or truth has no displacement"};
  const double value = metric.value(answer, truth, context);
  // Finite answers give NaN where they are 0/0, and infinity where they are too large to be squared.
  if (std::isnan(value))
    return {nan, "undefined: answer or truth has nothing of what is measured, or it was not recorded"};
  return std::isfinite(value) ? Mark{value, "ok"} : Mark{nan, "not_finite"};
}

double truth_size(const Metric& metric, const Trajectory& truth, const MetricContext& context) {
  expect_context(metric, context);
  expect_body(truth, context);
  if (says_nothing(metric, truth, context)) return nan;
  return metric.size ? metric.size(truth, context) : 1;
}

double distance(const Metric& metric, const Trajectory& a, const Trajectory& b, const MetricContext& context) {
  const double own = metric.of_truth_alone
                         ? std::abs(mark(metric, a, a, context).value - mark(metric, b, b, context).value)
                         : std::abs(mark(metric, a, b, context).value);
  if (!metric.whole) return own;
  const double whole = 2 * distance(mb::metric(metric.whole), a, b, context) * metric.share(b, context);
  return std::isfinite(own) ? std::max(own, whole) : own;
}

}  // namespace mb
