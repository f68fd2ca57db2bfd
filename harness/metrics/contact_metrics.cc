#include "harness/metrics/contact_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/metrics/momentum_audit.h"
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

const std::vector<Touch>& touches_of(const Trajectory& trajectory, const MetricContext& context) {
  return of(trajectory, context).contact.touches;
}
// NaN where the truth has nothing of it.
double ratio(double error, double size) { return size > 0 ? error / size : nan; }

// error(a, b) of the first contacts of answer and truth; NaN where one of them never touches.
template <class Error>
double compared(const Trajectory& answer, const Trajectory& truth, const MetricContext& context, const Error& error) {
  const auto& touches = touches_of(truth, context);
  const auto a = first_contact(touches_of(answer, context), touches), b = first_contact(touches, touches);
  return a && b ? error(a->whole, b->whole) : nan;
}

double first_touch_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return compared(answer, truth, context, [](const Touch& a, const Touch& b) { return std::abs(a.start - b.start); });
}
// NaN where one of them lasts: it has no duration as yet.
double duration_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return compared(answer, truth, context, [](const Touch& a, const Touch& b) {
    if (!std::isfinite(a.end) || !std::isfinite(b.end)) return nan;
    return ratio(std::abs((a.end - a.start) - (b.end - b.start)), b.end - b.start);
  });
}
double peak_force_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return compared(answer, truth, context, [](const Touch& a, const Touch& b) {
    return ratio(std::abs(a.peak_force - b.peak_force), b.peak_force);
  });
}
double impulse_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  return compared(answer, truth, context, [](const Touch& a, const Touch& b) {
    return ratio((a.impulse - b.impulse).norm(), b.impulse.norm());
  });
}
double restitution_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  if (!context.free && !striker_of(context.scene, body(context))) return nan;
  const auto value = [&](const Touch& t) { return restitution(context.scene, body(context), t); };
  return compared(answer, truth, context,
                  [&](const Touch& a, const Touch& b) { return std::abs(value(a) - value(b)); });
}
double n_touches(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  if (touches_of(truth, context).empty()) return nan;
  const auto contact = first_contact(touches_of(answer, context), touches_of(truth, context));
  return contact ? contact->n_touches : 0;
}

double force_error(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  const Matrix3Xd &f = of(answer, context).contact.force, &f_true = of(truth, context).contact.force;
  const VectorXd tau = trapezoid_weights(truth.t);
  if (f.cols() != tau.size() || f_true.cols() != tau.size()) return nan;
  const double error = (f - f_true).colwise().squaredNorm().dot(tau);
  return std::sqrt(ratio(error, f_true.colwise().squaredNorm().dot(tau)));
}

bool has_motion(const Trajectory& answer, const MetricContext& context) {
  return of(answer, context).displacement.cols() == answer.t.size();
}
// c(t_k) of a free body's centroid [m].
Vector3d centroid_at(const Trajectory& answer, const MetricContext& context, Index k) {
  const auto& [X, w] = context.points.volume;
  return rigid_frame(X, w, of(answer, context).displacement.col(k).head(3 * X.cols())).c;
}

// [J] What is in play of one body: the kinetic energy at the first touch, that of what strikes the body included, the
// largest that contacts hold, or the largest work of the weight.
double own_energy_brought(const Trajectory& answer, const MetricContext& context) {
  const Body& b = body(context);
  if (const Obstacle* obstacle = striker_of(context.scene, b))
    return 0.5 * obstacle->striker->mass * obstacle->striker->speed * obstacle->striker->speed;
  const auto& touches = touches_of(answer, context);
  const Vector3d v = b.twist.velocity + (touches.empty() ? 0 : touches.front().start) * context.scene.gravity;
  const double stored = of(answer, context).contact.stored.maxCoeff();
  double work = 0;
  if (context.free && !context.scene.gravity.isZero(0) && has_motion(answer, context))
    for (Index k = 1; k < answer.t.size(); ++k) {
      const Vector3d way = centroid_at(answer, context, k) - centroid_at(answer, context, 0);
      work = std::max(work, mass(b) * std::abs(context.scene.gravity.dot(way)));
    }
  return std::max({0.5 * mass(b) * v.squaredNorm(), stored, work});
}

// Of all bodies: what meets shares its energy.
double energy_brought(const Trajectory& answer, const MetricContext& context) {
  double sum = 0;
  for (std::size_t i = 0; i < context.scene.bodies.size(); ++i) {
    const auto place = static_cast<Index>(i);
    if (place == context.body) {
      sum += own_energy_brought(answer, context);
    } else if (const Body& other = context.scene.bodies[i]; !is_held(other)) {  // what is held is at rest
      const EvaluationPoints points = evaluation_points(context.scene, other);
      sum += own_energy_brought(answer, {context.scene, place, points, true});
    }
  }
  return sum;
}

// [J] Of all bodies, with what contacts have lost; of size 0 where it was not recorded or is not finite.
VectorXd energy_kept(const Trajectory& answer, const MetricContext&) {
  VectorXd sum = VectorXd::Zero(answer.t.size());
  for (const BodyTrajectory& b : answer.bodies) {
    const auto& [force, impulse, stored, dissipated, touches] = b.contact;
    if (b.energy.size() != sum.size() || dissipated.size() != sum.size() || stored.size() != sum.size()) return {};
    if (!stored.allFinite()) return {};
    sum += b.energy + dissipated;
  }
  return sum.allFinite() ? sum : VectorXd();
}

double energy_gain(const Trajectory& answer, const Trajectory&, const MetricContext& context) {
  const VectorXd kept = energy_kept(answer, context);
  if (kept.size() == 0) return nan;
  return ratio(std::max(0.0, (kept.array() - kept[0]).maxCoeff()), energy_brought(answer, context));
}

bool is_isolated(const Scene& scene) {
  const auto stands = [](const Support& support) { return !support.drive; };
  return scene.loads.empty() &&
         std::ranges::all_of(scene.bodies, [&](const Body& b) { return std::ranges::all_of(b.supports, stands); });
}

// Damping of the body and loads take and bring what is not in the sum.
bool keeps_energy(const MetricContext& context) {
  const auto undamped = [](const Body& b) {
    return b.damping.alpha == 0 && b.damping.beta == 0 &&
           std::ranges::all_of(b.damping_ratios, [](double zeta) { return zeta == 0; });
  };
  return std::ranges::all_of(context.scene.bodies, undamped) && context.scene.loads.empty();
}
double energy_defect(const Trajectory& answer, const Trajectory&, const MetricContext& context) {
  const VectorXd kept = energy_kept(answer, context);
  if (kept.size() == 0 || !keeps_energy(context)) return nan;
  return ratio(std::abs(kept[kept.size() - 1] - kept[0]), energy_brought(answer, context));
}

// Centroid's path against that of all forces on it: [c - v t - g t^2/2] from the first time to the last - int J dt / m,
// J the impulse since t = 0.
double momentum_defect(const Trajectory& answer, const Trajectory&, const MetricContext& context) {
  if (!context.free) return nan;
  const Body& b = body(context);
  const BodyTrajectory& moved = of(answer, context);
  const Index n = answer.t.size();
  if (moved.contact.impulse.cols() != n || n < 2 || !has_motion(answer, context)) return nan;
  const double t0 = answer.t[0], T = answer.t[n - 1];
  const auto place = [&](Index k) { return centroid_at(answer, context, k); };
  const Vector3d pushed = moved.contact.impulse * trapezoid_weights(answer.t) / mass(b);  // int J dt / m
  const Vector3d thrown = (T - t0) * b.twist.velocity + (T * T - t0 * t0) / 2 * context.scene.gravity;
  const Vector3d defect = place(n - 1) - place(0) - thrown - pushed;
  return ratio(defect.norm(), pushed.norm());
}

double touch_size(const Trajectory&, const MetricContext&) { return 1; }
// 1 + e = J/(m v), what a relative error of the impulse comes to.
double impulse_share(const Trajectory& truth, const MetricContext& context) {
  const auto contact = first_contact(touches_of(truth, context), touches_of(truth, context));
  return contact ? 1 + restitution(context.scene, body(context), contact->whole) : nan;
}

}  // namespace

std::optional<FirstContact> first_contact(const std::vector<Touch>& touches, const std::vector<Touch>& truth) {
  if (touches.empty() || truth.empty()) return {};
  const Touch& own = truth.front();
  const double until = own.end + 0.5 * (own.end - own.start);
  FirstContact all{touches.front(), 1};
  for (auto next = touches.begin() + 1; next != touches.end() && next->start < until; ++next) {
    all.whole.end = next->end;
    if (next->peak_force > all.whole.peak_force)
      all.whole.peak_force = next->peak_force, all.whole.peak_time = next->peak_time;
    all.whole.impulse += next->impulse;
    ++all.n_touches;
  }
  return all;
}

namespace {

// The other body of a contact, where nothing holds it.
const Body* free_partner(const Scene& scene, const Body& b) {
  for (const ContactPair& pair : scene.contacts)
    for (const Body& other : scene.bodies)
      if (!is_held(other) && other.name != b.name &&
          ((pair.body == b.name && pair.obstacle == other.name) ||
           (pair.body == other.name && pair.obstacle == b.name)))
        return &other;
  return nullptr;
}

}  // namespace

double energy_fed(const Trajectory& answer, const Trajectory& truth, const MetricContext& context) {
  if (!is_isolated(context.scene)) return nan;
  VectorXd sum = VectorXd::Zero(answer.t.size());
  for (const BodyTrajectory& b : answer.bodies) {
    if (b.energy.size() != sum.size()) return nan;
    sum += b.energy;
  }
  return ratio((sum.array() - sum[0]).maxCoeff(), energy_brought(truth, context));
}

double restitution(const Scene& scene, const Body& b, const Touch& touch) {
  if (!std::isfinite(touch.end)) return nan;
  if (const Obstacle* obstacle = striker_of(scene, b)) {
    const auto& [m, speed, E, nu] = *obstacle->striker;
    const Vector3d up = b.pose.orientation * Vector3d::UnitZ();
    return -touch.impulse.dot(up) / (m * speed) - 1;  // the impulse is that on the body
  }
  Vector3d v = b.twist.velocity + touch.start * scene.gravity;
  Vector3d after = v + touch.impulse / mass(b) + (touch.end - touch.start) * scene.gravity;
  if (const Body* other = free_partner(scene, b)) {  // both fall alike: gravity is of no account between them
    v = b.twist.velocity - other->twist.velocity;
    after = v + touch.impulse * (1 / mass(b) + 1 / mass(*other));
  }
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
  const auto at_any_mass = [](Metric m) { return m.per_mass = 0, m; };
  const auto of_impulse = [](Metric m) {
    m.per_mass = 2, m.whole = "impulse", m.share = &impulse_share;  // e = J/(m v) - 1 is off by 1 + e at most
    return m;
  };
  // Not an error, hence without a bar; the truth says no more than how far the first contact goes.
  const auto alone = [&](const char* name, const char* doc, auto value) {
    Metric m = add(name, "-", doc, value);
    m.of_answer_alone = true;
    return m;
  };
  return {
      at_any_mass(add("first-touch", "s", "Difference of the times of the first touch.", &first_touch_error)),
      relative(add("contact-duration", "-",
                   "Relative error of the duration of the first contact, from its first touch to the end of its last.",
                   &duration_error)),
      relative(add("peak-force", "-", "Relative error of the largest contact force of the first contact.",
                   &peak_force_error)),
      relative(add("impulse", "-", "Relative error of the impulse of the first contact, as a vector.", &impulse_error)),
      of_impulse(add("restitution", "-",
                     "Difference of the coefficients of restitution of the first contact, by the shape's own mass: a "
                     "mesh that lacks volume shows it; free bodies, and what strikes one.",
                     &restitution_error)),
      relative(add("force-error", "-", "Relative L2 error over time of the contact force.", &force_error)),
      alone("touches",
            "Touches in the first contact: 1 where it touches and lets go once, more where it chatters, 0 where it "
            "never touches.",
            &n_touches),
      alone("energy-gain",
            "Largest gain of energy over that at the start, losses in contact added back, by the largest energy in "
            "play: kinetic at the first touch, stored in contacts, or work of the weight. What the body's own damping "
            "has taken hides as much of a gain.",
            &energy_gain),
      alone(
          "energy-defect",
          "Energy gained or lost from the first time to the last, losses in contact added back, by the largest energy "
          "in play, as of energy-gain; bodies without damping or loads.",
          &energy_defect),
      alone("momentum-defect",
            "How far the centroid is from where weight and contact impulses take it, by the way that the impulses "
            "make, by the shape's own mass: a mesh that lacks volume shows it; free bodies.",
            &momentum_defect),
      alone("momentum-drift",
            "Largest difference of a free body's linear momentum and the impulses on it, while nothing presses, by the "
            "largest impulse; of two bodies also of what one takes and the other gives, and where both are free of "
            "their sum at every time. By the answer's own mass: what the scheme keeps, not what points see.",
            &momentum_drift),
      alone("angular-drift",
            "Largest change of the angular momentum of all bodies about the origin, by the largest impulse times the "
            "body's extent; scenes of free bodies without obstacles, gravity and loads.",
            &angular_drift)};
}

}  // namespace mb
