#include "harness/metrics/momentum_audit.h"

#include <algorithm>
#include <limits>

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const BodyTrajectory& of(const Trajectory& answer, const MetricContext& context) {
  return answer.bodies[static_cast<std::size_t>(context.body)];
}
const Body& body(const MetricContext& context) { return context.scene.bodies[static_cast<std::size_t>(context.body)]; }

bool has_momentum(const BodyTrajectory& b, Index n_t) { return b.momentum.cols() == n_t && b.momentum.allFinite(); }

double largest_impulse(const Trajectory& answer, const MetricContext& context) {
  const Matrix3Xd& J = of(answer, context).contact.impulse;
  return J.cols() == answer.t.size() && J.cols() > 0 && J.allFinite() ? J.colwise().norm().maxCoeff() : 0;
}

// Whether the impulse changes between the samples beside k: then a step in contact may reach there.
bool presses(const Matrix3Xd& J, Index k) {
  const Index before = std::max<Index>(0, k - 1), after = std::min(J.cols() - 1, k + 1);
  return J.col(before) != J.col(k) || J.col(k) != J.col(after);
}

// [N s] P(t) - P(0) - J(t), P(0) that of the first time, where J may have begun.
double own_drift(const Trajectory& answer, const BodyTrajectory& b) {
  double largest = 0;
  const auto less_impulse = [&](Index k) -> Vector3d { return b.momentum.col(k).head<3>() - b.contact.impulse.col(k); };
  for (Index k = 1; k < answer.t.size(); ++k)
    if (!presses(b.contact.impulse, k)) largest = std::max(largest, (less_impulse(k) - less_impulse(0)).norm());
  return largest;
}

// Of the scene: bodies that are free, and no others, in contact with each other alone.
bool only_free_bodies(const Scene& scene) {
  return scene.obstacles.empty() && scene.loads.empty() && !scene.contacts.empty() &&
         std::ranges::none_of(scene.bodies, [](const Body& b) { return is_held(b); });
}

// Largest change of the sum over all bodies, rows of the momentum; NaN where one has none.
double change_of_sum(const Trajectory& answer, Index first_row) {
  MatrixXd sum = MatrixXd::Zero(3, answer.t.size());
  for (const BodyTrajectory& b : answer.bodies) {
    if (!has_momentum(b, answer.t.size())) return nan;
    sum += b.momentum.middleRows(first_row, 3);
  }
  return (sum.colwise() - VectorXd(sum.col(0))).colwise().norm().maxCoeff();
}

}  // namespace

double momentum_drift(const Trajectory& answer, const Trajectory&, const MetricContext& context) {
  const double J = largest_impulse(answer, context);
  if (!(J > 0) || !context.scene.loads.empty()) return nan;
  const BodyTrajectory& own = of(answer, context);
  const bool pair = answer.bodies.size() == 2 && context.scene.contacts.size() == 1;
  if (context.free && !has_momentum(own, answer.t.size())) return nan;
  if (!context.free && !pair) return nan;
  double largest = context.free ? own_drift(answer, own) : 0;
  if (pair) {
    const Matrix3Xd &a = answer.bodies[0].contact.impulse, &b = answer.bodies[1].contact.impulse;
    if (a.cols() != b.cols()) return nan;
    largest = std::max(largest, (a + b).colwise().norm().maxCoeff());
  }
  if (only_free_bodies(context.scene)) largest = std::max(largest, change_of_sum(answer, 0));
  return largest / J;
}

double angular_drift(const Trajectory& answer, const Trajectory&, const MetricContext& context) {
  const double J = largest_impulse(answer, context);
  if (!(J > 0) || !only_free_bodies(context.scene) || !context.scene.gravity.isZero(0)) return nan;
  return change_of_sum(answer, 3) / (J * extent(body(context).shape));
}

}  // namespace mb
