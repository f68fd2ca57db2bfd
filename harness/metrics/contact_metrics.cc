#include "harness/metrics/contact_metrics.h"

#include <cmath>
#include <limits>

#include "harness/metrics/pose.h"
#include "harness/metrics/signal.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const Body& body(const MetricContext& context) { return context.scene.bodies[static_cast<std::size_t>(context.body)]; }
const BodyTrajectory& of(const Trajectory& trajectory, const MetricContext& context) {
  return trajectory.bodies[static_cast<std::size_t>(context.body)];
}
double mass(const Body& b) { return b.material.density * volume(b.shape); }

// The first touch that has ended; nothing where there is none.
const Touch* first_touch(const Trajectory& trajectory, const MetricContext& context) {
  const auto& touches = of(trajectory, context).contact.touches;
  return touches.empty() ? nullptr : &touches.front();
}

// |value(a) - value(b)| over `by`; NaN where one of them has no touch.
template <class Value>
double difference(const Trajectory& answer, const Trajectory& truth, const MetricContext& context, const Value& value,
                  bool relative) {
  const Touch *a = first_touch(answer, context), *b = first_touch(truth, context);
  if (!a || !b) return nan;
  const double error = std::abs(value(*a) - value(*b));
  return relative ? error / std::abs(value(*b)) : error;
}

double first_touch_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return difference(
      answer, truth, context, [](const Touch& t) { return t.start; }, false);
}
double duration_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return difference(
      answer, truth, context, [](const Touch& t) { return t.end - t.start; }, true);
}
double peak_force_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return difference(
      answer, truth, context, [](const Touch& t) { return t.peak_force; }, true);
}
double impulse_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  const Touch *a = first_touch(answer, context), *b = first_touch(truth, context);
  return a && b ? (a->impulse - b->impulse).norm() / b->impulse.norm() : nan;
}
double restitution_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  if (!context.free && !striker_of(context.scene, body(context))) return nan;
  const auto value = [&](const Touch& t) { return restitution(context.scene, body(context), t); };
  return difference(answer, truth, context, value, false);
}

double force_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  const Matrix3Xd &f = of(answer, context).contact.force, &f_true = of(truth, context).contact.force;
  const VectorXd tau = trapezoid_weights(truth.t);
  if (f.cols() != tau.size() || f_true.cols() != tau.size()) return nan;
  const double size = f_true.colwise().squaredNorm().dot(tau);
  return size > 0 ? std::sqrt((f - f_true).colwise().squaredNorm().dot(tau) / size) : nan;
}

// c(t_k) of a free body's centroid [m].
Vector3d centroid_at(const Trajectory& answer, const MetricContext& context, Index k) {
  const auto& [X, w] = context.points.volume;
  return rigid_frame(X, w, of(answer, context).displacement.col(k).head(3 * X.cols())).c;
}

// [J] What is in play: the kinetic energy at the first touch, that of what strikes the body included, the largest that
// contacts hold, or the largest work of the weight.
double energy_brought(const Trajectory& answer, const MetricContext& context) {
  const Body& b = body(context);
  if (const Obstacle* obstacle = striker_of(context.scene, b))
    return 0.5 * obstacle->striker->mass * obstacle->striker->speed * obstacle->striker->speed;
  const Touch* touch = first_touch(answer, context);
  const Vector3d v = b.twist.velocity + (touch ? touch->start : 0) * context.scene.gravity;
  const double stored = of(answer, context).contact.stored.maxCoeff();
  double work = 0;
  if (context.free && !context.scene.gravity.isZero(0))
    for (Index k = 1; k < answer.t.size(); ++k) {
      const Vector3d way = centroid_at(answer, context, k) - centroid_at(answer, context, 0);
      work = std::max(work, mass(b) * std::abs(context.scene.gravity.dot(way)));
    }
  return std::max({0.5 * mass(b) * v.squaredNorm(), stored, work});
}

double energy_gain(const Trajectory& answer, const Trajectory&, const MetricContext& context) {
  const BodyTrajectory& b = of(answer, context);
  if (b.energy.size() == 0 || b.contact.dissipated.size() != b.energy.size()) return nan;
  const VectorXd kept = b.energy + b.contact.dissipated;
  return std::max(0.0, (kept.array() - kept[0]).maxCoeff()) / energy_brought(answer, context);
}

// Centroid's path against that of all forces on it: [c - v t - g t^2/2] from the first time to the last - int J dt / m,
// J the impulse since t = 0.
double momentum_defect(const Trajectory& answer, const Trajectory&, const MetricContext& context) {
  if (!context.free) return nan;
  const Body& b = body(context);
  const BodyTrajectory& moved = of(answer, context);
  const Index n = answer.t.size();
  if (moved.contact.impulse.cols() != n || n < 2) return nan;
  const double t0 = answer.t[0], T = answer.t[n - 1];
  const auto place = [&](Index k) { return centroid_at(answer, context, k); };
  const Vector3d pushed = moved.contact.impulse * trapezoid_weights(answer.t) / mass(b);  // int J dt / m
  const Vector3d thrown = (T - t0) * b.twist.velocity + (T * T - t0 * t0) / 2 * context.scene.gravity;
  const Vector3d defect = place(n - 1) - place(0) - thrown - pushed;
  const double size = pushed.norm();
  return size > 0 ? defect.norm() / size : nan;
}

double touch_size(const Trajectory&, const MetricContext&) { return 1; }

}  // namespace

double restitution(const Scene& scene, const Body& b, const Touch& touch) {
  if (const Obstacle* obstacle = striker_of(scene, b)) {
    const auto& [m, speed, E, nu] = *obstacle->striker;
    const Vector3d up = b.pose.orientation * Vector3d::UnitZ();
    return -touch.impulse.dot(up) / (m * speed) - 1;  // the impulse is that on the body
  }
  const Vector3d v = b.twist.velocity + touch.start * scene.gravity;
  const Vector3d after = v + touch.impulse / mass(b) + (touch.end - touch.start) * scene.gravity;
  const Vector3d along = touch.impulse.normalized();
  return -after.dot(along) / v.dot(along);
}

std::vector<Metric> contact_metrics() {
  constexpr bool no = false;
  const auto add = [&](const char* name, const char* unit, const char* doc, auto value) {
    Metric m{name, unit, doc, no, no, no, value, &touch_size};
    m.contact_only = true;
    return m;
  };
  std::vector<Metric> all = {
      add("first-touch", "s", "Difference of the times of the first touch.", &first_touch_error),
      add("contact-duration", "-", "Relative error of the duration of the first touch.", &duration_error),
      add("peak-force", "-", "Relative error of the largest contact force of the first touch.", &peak_force_error),
      add("impulse", "-", "Relative error of the impulse of the first touch, as a vector.", &impulse_error),
      add("restitution", "-",
          "Difference of the coefficients of restitution of the first touch; free bodies, and what strikes one.",
          &restitution_error),
      add("force-error", "-", "Relative L2 error over time of the contact force.", &force_error),
      add("energy-gain", "-",
          "Largest gain of energy, losses in contact added back, by the kinetic energy at the first touch.",
          &energy_gain),
      add("momentum-defect", "-",
          "How far the centroid is from where weight and contact impulses take it, by the way that the impulses make; "
          "free bodies.",
          &momentum_defect)};
  for (Metric& metric : all) metric.of_answer_alone = metric.name == "energy-gain" || metric.name == "momentum-defect";
  return all;
}

}  // namespace mb
