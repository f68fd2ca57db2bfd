#include "modal/contact/next_touch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "mechanics/contact/first_touch.h"
#include "mechanics/contact/first_touch_support.h"
#include "modal/contact/flight_bounds.h"

namespace mb {

namespace {

constexpr double tolerance = 1e-12;  // [-] of the extent
constexpr double depth = 0.05;       // [-] of the extent: how far a body that lets go may still overlap
constexpr double step_cost = 16;     // evaluations of the motion that a step in contact costs as much as
constexpr double least_budget = 100, most_budget = 2e6;  // evaluations

Eigen::Matrix3d cross_matrix(const Vector3d& w) {
  Eigen::Matrix3d W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return W;
}

class FloatingMotion final : public BodyMotion {
 public:
  FloatingMotion(const ImpactPlan& plan, const BodyFlight& flight)
      : plan_(plan), flight_(flight), circumradius_(circumradius(plan.shape)) {}

  void at(double t, std::span<const Vector3d> X, std::span<PointMotion> out) const override {
    if (t != t_) look(t);
    const Eigen::Matrix3d WQ = W_ * Q_;
    for (size_t i = 0; i < X.size(); ++i) {
      const auto u = deformation_->at(X[i]);
      const auto rate = rate_->at(X[i]);
      const Vector3d arm = Q_ * u.x;
      out[i] = {state_.c + arm, state_.v + W_ * arm + Q_ * (rate.x - X[i]), Q_ * u.F,
                WQ * u.F + Q_ * (rate.F - Eigen::Matrix3d::Identity())};
    }
  }

  MotionBounds bounds(double ta, double tb) const override {
    if (ta != t_) look(ta);  // what is damped away by then bounds nothing
    const FlightBounds b = flight_bounds(plan_.body, plan_.bounds, state_, tb - ta).value();
    return {plan_.body.free ? plan_.body.gravity : Vector3d::Zero(),
            (b.Omega_t + b.Omega * b.Omega) * (circumradius_ + b.u) + 2 * b.Omega * b.u_t + b.u_tt, b.bend,
            b.bend_rate + b.Omega * b.bend};
  }

 private:
  void look(double t) const {
    t_ = t;
    state_ = flight_.at(t);
    Q_ = state_.Q.toRotationMatrix();
    W_ = cross_matrix(angular_velocity(plan_.body, state_));
    deformation_.emplace(plan_.geometry.map(state_.q));
    rate_.emplace(plan_.geometry.map(rates(plan_.body, state_)));
  }

  const ImpactPlan& plan_;
  const BodyFlight& flight_;
  double circumradius_;
  mutable double t_ = std::numeric_limits<double>::quiet_NaN();
  mutable BodyState state_;
  mutable Eigen::Matrix3d Q_, W_;
  mutable std::optional<PolynomialMap> deformation_, rate_;
};

struct Window {
  double from, to;
};  // [s]

// When the body can touch a half-space at all: where  n . (c - a) - h <= 0,  h the undeformed body's reach along -n
// plus its largest deformation; c is a parabola in time. At most two windows of [from, to].
std::vector<Window> windows(const ImpactPlan& plan, const BodyState& start, const RigidSurface& surface, double from,
                            double to) {
  if (!plan.body.free || !std::holds_alternative<HalfSpace>(surface.shape)) return {{from, to}};
  const Vector3d n = surface.pose.orientation * Vector3d::UnitZ();
  const FlightBounds bounds = flight_bounds(plan.body, plan.bounds, start, to - from).value();
  const Vector3d down = start.Q.conjugate() * -n;
  const double reach =
      (bounds.Omega == 0 ? down.dot(support_point(plan.shape, down)) : circumradius(plan.shape)) + bounds.u;
  const double height = n.dot(start.c - surface.pose.position) - reach, climb = n.dot(start.v),
               pull = n.dot(plan.body.gravity);  // height + climb t + pull t^2/2 <= 0
  if (pull > 0) return {{from, to}};
  const double root = climb * climb - 2 * pull * height;
  if (pull == 0) {
    if (height <= 0 && climb <= 0) return {{from, to}};
    const double crossing = climb == 0 ? std::numeric_limits<double>::infinity() : -height / climb;
    if (climb >= 0)
      return height > 0 ? std::vector<Window>() : std::vector<Window>{{from, std::min(to, from + crossing)}};
    return from + crossing >= to ? std::vector<Window>() : std::vector<Window>{{from + std::max(0.0, crossing), to}};
  }
  if (root <= 0) return {{from, to}};                                 // it never rises out of reach
  const double half = climb + std::copysign(std::sqrt(root), climb);  // roots -half/pull and -2 height/half
  const double t1 = from + std::min(-half / pull, -2 * height / half),
               t2 = from + std::max(-half / pull, -2 * height / half);
  std::vector<Window> open;
  if (t1 > from) open.push_back({from, std::min(t1, to)});
  if (t2 < to) open.push_back({std::max(t2, from), to});
  return open;
}

}  // namespace

std::optional<NextTouch> next_touch(const ImpactPlan& plan, const BodyFlight& flight, double end, bool leaving) {
  const BodyState start = flight.at(flight.start());
  if (!is_finite(start) || !plan.body.gravity.allFinite())
    throw std::invalid_argument("next touch: the state or the gravity of the body in flight is not finite");
  const auto meets_none = [](const SampledContact& contact) { return contact.partner != nullptr; };
  if (!(end > flight.start()) || std::ranges::all_of(plan.body.contacts, meets_none)) return std::nullopt;
  if (!flight_bounds(plan.body, plan.bounds, start, end - flight.start())) return NextTouch{flight.start(), false};
  const double l = extent(plan.shape);
  const FloatingMotion motion(plan, flight);
  std::optional<NextTouch> earliest;
  for (const SampledContact& contact : plan.body.contacts) {
    if (contact.partner) continue;  // meetings.h
    for (const Window& w : windows(plan, start, contact.surface, flight.start(), earliest ? earliest->t : end)) {
      const bool at_start = leaving && w.from == flight.start();
      // A search is not to cost more than the steps that it saves.
      const auto budget =
          static_cast<long>(std::clamp(step_cost * (w.to - w.from) / plan.step, least_budget, most_budget));
      const auto touch = first_touch(plan.shape, motion, contact.surface,
                                     {.t0 = w.from,
                                      .t1 = w.to,
                                      .tolerance = tolerance * l,
                                      .leaving = at_start,
                                      .depth = (at_start ? depth : tolerance) * l,
                                      .budget = budget});
      if (!touch) continue;
      earliest = {touch->t, touch->kind != FirstTouch::undecided};
      break;
    }
  }
  return earliest;
}

}  // namespace mb
