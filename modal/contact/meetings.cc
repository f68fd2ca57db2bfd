#include "modal/contact/meetings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/contact/first_touch_support.h"
#include "mechanics/geometry/signed_distance.h"
#include "modal/contact/flight_bounds.h"
#include "modal/frame/spin.h"

namespace mb {

namespace {

constexpr int most_looks = 60;
constexpr double sharp = 1e-6;  // [-] of a step: samples lie farther apart than what moves then
constexpr double aside = 0.25;  // [-] how far the normal at the nearest sample may be off that at the nearest point

double largest_displacement(const ImpactPlan& plan, const BodyState& state, double duration) {
  const auto bounds = flight_bounds(plan.body, plan.bounds, state, duration);
  return bounds ? bounds->u : std::numeric_limits<double>::infinity();
}

Vector3d pull(const ImpactPlan& plan) { return plan.body.free ? plan.body.gravity : Vector3d::Zero(); }

// The least t > 0 [s] at which d + w t - p t^2 / 2 is no longer positive, d > 0; infinity: never.
double time_to_close(double d, double w, double p) {
  const double root = w * w + 2 * p * d;
  if (!(root >= 0)) return std::isnan(root) ? 0 : std::numeric_limits<double>::infinity();
  if (w < 0) return 2 * d / (std::sqrt(root) - w);
  return p > 0 ? (w + std::sqrt(root)) / p : std::numeric_limits<double>::infinity();
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

Meetings::Sight Meetings::see(const Pair& of, const std::vector<BodyFlight>& flights, double t) const {
  const FloatingBody &a = plans_[of.a].body, &b = plans_[of.b].body;
  Sight now{t, flights[of.a].at(t), flights[of.b].at(t), {}, {}, Vector3d::Zero(), Vector3d::Zero()};
  now.rate_a = rates(a, now.a), now.rate_b = rates(b, now.b);
  now.Omega_a = angular_velocity(a, now.a), now.Omega_b = angular_velocity(b, now.b);
  return now;
}

double Meetings::clear_for(const Pair& of, const Sight& now, double end) const {
  const ImpactPlan &a = plans_[of.a], &b = plans_[of.b];
  const double u = largest_displacement(a, now.a, end - now.t) + largest_displacement(b, now.b, end - now.t);
  if (!std::isfinite(u)) return 0;
  const Vector3d apart = now.a.c - now.b.c;
  const Distance at_rest = signed_distance(b.shape, now.b.Q.conjugate() * apart);
  const double d = at_rest.value - of.radius - u;
  if (!(d > 0)) return 0;
  const Vector3d n = now.b.Q * at_rest.gradient, v = now.a.v - now.b.v, g = pull(a) - pull(b);
  // a's centre as seen from b.
  const double Omega = b.body.free ? flight_bounds(b.body, b.bounds, now.b, end - now.t)->Omega : 0;
  if (Omega == 0) return time_to_close(d, n.dot(v), -n.dot(g));
  // d <= v t + (g + 2 Omega (v + g t)) t^2 / 2 while Omega t is small; beyond that another look.
  const double most = v.norm() + Omega * apart.norm(), small = 0.1;
  return std::min(time_to_close(d, n.dot(v) - Omega * apart.norm(), (1 + 2 * small) * g.norm() + 2 * Omega * most),
                  small / Omega);
}

double Meetings::open_for(const Pair& of, const Sight& now) const {
  const ImpactPlan &a = plans_[of.a], &b = plans_[of.b];
  const BodyPair::Nearest at = of.pair->nearest(now.a, now.b);
  if (!(at.clearance > 0)) return 0;
  const double vibration =
      of.pair->shaking(at, {&now.a, now.Omega_a, &now.rate_a}, {&now.b, now.Omega_b, &now.rate_b}, aside);
  const double spin = now.Omega_a.norm() * of.radius + now.Omega_b.norm() * circumradius(b.shape);
  const auto towards = [&](const Vector3d& w) {  // at least, of a speed or pull
    const double along = at.normal.dot(w);
    return along - aside * (w - along * at.normal).norm();
  };
  return time_to_close(at.clearance, towards(now.a.v - now.b.v) - spin - vibration, -towards(pull(a) - pull(b)));
}

double Meetings::least_gap(Pair& of, const Sight& now) const {
  of.pair->look({&now.a, now.Omega_a, &now.rate_a}, {&now.b, now.Omega_b, &now.rate_b});
  return of.pair->least_gap();
}

// Chords, and halves where these creep.
double Meetings::first_zero(Pair& of, const std::vector<BodyFlight>& flights, double from, double to, double gap_from,
                            double gap_to) const {
  const double width = sharp * (to - from);
  for (int k = 0; k < most_looks && to - from > width; ++k) {
    const bool halve = k % 4 == 3 || !std::isfinite(gap_from);  // where the chord creeps; nothing in reach
    const double x = halve ? 0.5 : gap_from / (gap_from - gap_to);
    // Beyond the chord's zero by a little: both ends close in.
    const double t =
        std::clamp(from + x * (to - from) + (k % 2 ? width / 2 : -width / 2), from + width / 4, to - width / 4);
    const double gap = least_gap(of, see(of, flights, t));
    (gap < 0 ? to : from) = t;
    (gap < 0 ? gap_to : gap_from) = gap;
  }
  return to;
}

std::optional<NextTouch> Meetings::next(Pair& of, const std::vector<BodyFlight>& flights, double end) const {
  const double step = plans_.front().step;
  Sight now = see(of, flights, flights.front().start());
  double gap = std::numeric_limits<double>::infinity();  // [m] now, where it was looked at
  if (!(clear_for(of, now, end) > 0)) gap = least_gap(of, now);
  if (gap < 0) return NextTouch{now.t, true};
  while (now.t < end) {
    double clear = clear_for(of, now, end);
    if (!(clear > step)) clear = open_for(of, now);
    if (now.t + clear >= end) break;
    if (clear > step) {
      now = see(of, flights, now.t + clear);
      gap = std::numeric_limits<double>::infinity();
      continue;
    }
    Sight ahead = see(of, flights, std::min(now.t + step, end));
    const double gap_ahead = least_gap(of, ahead);
    if (gap_ahead < 0) return NextTouch{first_zero(of, flights, now.t, ahead.t, gap, gap_ahead), true};
    now = std::move(ahead);
    gap = gap_ahead;
  }
  return {};
}

}  // namespace mb
