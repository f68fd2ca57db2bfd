#include "modal/contact/meetings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/contact/first_touch_support.h"
#include "mechanics/geometry/signed_distance.h"
#include "modal/contact/flight_bounds.h"
#include "modal/contact/spin.h"

namespace mb {

namespace {

constexpr int most_looks = 60;
constexpr double sharp = 1e-6;  // [-] of a step: samples lie farther apart than what moves then

double largest_displacement(const ImpactPlan& plan, const BodyState& state, double duration) {
  const auto bounds = flight_bounds(plan.body, plan.bounds, state, duration);
  return bounds ? bounds->u : std::numeric_limits<double>::infinity();
}

}  // namespace

Meetings::Meetings(std::span<const ImpactPlan> plans) : plans_(plans) {
  for (size_t a = 0; a < plans.size(); ++a)
    for (const SampledContact& contact : plans[a].body.contacts) {
      if (!contact.partner) continue;
      const size_t b = contact.partner->body;
      pairs_.push_back(
          {a, b, circumradius(plans[a].shape), std::make_unique<BodyPair>(plans[a].body, plans[b].body, contact)});
    }
}

std::optional<NextTouch> Meetings::next(const std::vector<BodyFlight>& flights, double end, bool leaving) {
  std::optional<NextTouch> earliest;
  const auto note = [&](const std::optional<NextTouch>& touch) {
    if (touch && (!earliest || touch->t < earliest->t)) earliest = touch;
  };
  for (size_t b = 0; b < plans_.size(); ++b)
    note(next_touch(plans_[b], flights[b], earliest ? earliest->t : end, leaving));
  for (Pair& pair : pairs_) note(next(pair, flights, earliest ? earliest->t : end));
  return earliest;
}

double Meetings::clear_for(const Pair& of, const std::vector<BodyFlight>& flights, double t, double end) const {
  const ImpactPlan &a = plans_[of.a], &b = plans_[of.b];
  const BodyState at_a = flights[of.a].at(t), at_b = flights[of.b].at(t);
  const double u = largest_displacement(a, at_a, end - t) + largest_displacement(b, at_b, end - t);
  if (!std::isfinite(u)) return 0;
  const Vector3d apart = at_a.c - at_b.c;
  const double d = signed_distance_value(b.shape, at_b.Q.conjugate() * apart) - of.radius - u;
  if (!(d > 0)) return 0;
  const auto acceleration = [](const ImpactPlan& plan) {
    return plan.body.free ? plan.body.gravity : Vector3d::Zero();
  };
  const auto spin_of = [](const ImpactPlan& plan, const BodyState& at) {
    return plan.body.free ? angular_velocity(plan.body, at).norm() : 0.0;
  };
  // a's centre as seen from b, which turns no faster than its momentum lets it.
  const double J = b.body.free ? Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(b.body.inertia).eigenvalues()[0] : 1;
  const double Omega = b.body.free ? std::max(spin_of(b, at_b), at_b.L.norm() / J) : 0;
  const double g = (acceleration(a) - acceleration(b)).norm(), v = (at_a.v - at_b.v).norm() + Omega * apart.norm();
  // d <= v t + (g + 2 Omega v) t^2 / 2 while Omega t is small; beyond that another look.
  const double pull = g + 2 * Omega * v, most = Omega > 0 ? 0.1 / Omega : std::numeric_limits<double>::infinity();
  const double used = pull > 0 ? 2 * d / (v + std::sqrt(v * v + 2 * pull * d)) : v > 0 ? d / v : end - t;
  return std::min(used, most);
}

double Meetings::shaking(const Pair& of, const std::vector<BodyFlight>& flights, double t) const {
  const FloatingBody &a = plans_[of.a].body, &b = plans_[of.b].body;
  const BodyState at_a = flights[of.a].at(t), at_b = flights[of.b].at(t);
  const VectorXd rate_a = rates(a, at_a), rate_b = rates(b, at_b);
  return of.pair->shaking({&at_a, Vector3d::Zero(), &rate_a}, {&at_b, Vector3d::Zero(), &rate_b});
}

double Meetings::open_for(const Pair& of, const std::vector<BodyFlight>& flights, double t, double rate) const {
  const BodyState at_a = flights[of.a].at(t), at_b = flights[of.b].at(t);
  const auto pull = [](const ImpactPlan& plan) { return plan.body.free ? plan.body.gravity : Vector3d::Zero(); };
  const auto turning = [](const ImpactPlan& plan, const BodyState& at) {
    return plan.body.free ? angular_velocity(plan.body, at).norm() * circumradius(plan.shape) : 0.0;
  };
  const double v = (at_a.v - at_b.v).norm() + turning(plans_[of.a], at_a) + turning(plans_[of.b], at_b) + rate,
               g = (pull(plans_[of.a]) - pull(plans_[of.b])).norm(), d = of.pair->clearance();
  if (!(d > 0) || !std::isfinite(v)) return 0;
  return g > 0 ? 2 * d / (v + std::sqrt(v * v + 2 * g * d)) : d / v;
}

double Meetings::least_gap(Pair& of, const std::vector<BodyFlight>& flights, double t) const {
  const FloatingBody &a = plans_[of.a].body, &b = plans_[of.b].body;
  const BodyState at_a = flights[of.a].at(t), at_b = flights[of.b].at(t);
  const VectorXd rate_a = rates(a, at_a), rate_b = rates(b, at_b);
  of.pair->look({&at_a, angular_velocity(a, at_a), &rate_a}, {&at_b, angular_velocity(b, at_b), &rate_b});
  return of.pair->least_gap();
}

// Chords, and halves where these creep.
double Meetings::first_zero(Pair& of, const std::vector<BodyFlight>& flights, double from, double to) const {
  double gap_from = least_gap(of, flights, from), gap_to = least_gap(of, flights, to);
  const double width = sharp * (to - from);
  for (int k = 0; k < most_looks && to - from > width; ++k) {
    const bool halve = k % 3 == 2 || !std::isfinite(gap_from);  // where the chord creeps; nothing in reach
    const double x = halve ? 0.5 : gap_from / (gap_from - gap_to);
    // Beyond the chord's zero by a little: both ends close in.
    const double t =
        std::clamp(from + x * (to - from) + (k % 2 ? width / 2 : -width / 2), from + width / 4, to - width / 4);
    const double gap = least_gap(of, flights, t);
    (gap < 0 ? to : from) = t;
    (gap < 0 ? gap_to : gap_from) = gap;
  }
  return to;
}

std::optional<NextTouch> Meetings::next(Pair& of, const std::vector<BodyFlight>& flights, double end) const {
  const double step = plans_.front().step;
  double t = flights.front().start(), looked = t;
  if (least_gap(of, flights, t) < 0) return NextTouch{t, true};
  const double rate = shaking(of, flights, t);
  while (t < end) {
    double clear = clear_for(of, flights, t, end);
    if (!(clear > step)) {
      if (looked != t) least_gap(of, flights, looked = t);
      clear = open_for(of, flights, t, rate);
    }
    if (clear > step) {
      t += clear;
      continue;
    }
    const double next = std::min(t + step, end);
    if (least_gap(of, flights, next) < 0) return NextTouch{first_zero(of, flights, t, next), true};
    if (next == end) break;
    looked = t = next;
  }
  return {};
}

}  // namespace mb
