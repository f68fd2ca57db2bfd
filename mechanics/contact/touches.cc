#include "mechanics/contact/touches.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {

namespace {

constexpr double short_separation = 0.1;  // [-] of the longer touch beside it
constexpr double most_unequal = 10;       // [-] steps

// Where the gap passes zero between two moments, as a line.
double crossing(const ContactMoment& a, const ContactMoment& b) {
  const double x = a.least_gap / (a.least_gap - b.least_gap);
  return std::isfinite(x) ? a.t + (b.t - a.t) * std::min(1.0, std::max(0.0, x)) : b.t;
}

struct Peak {
  double t, force;
};
// Vertex of the parabola through three moments, the middle one the largest; where steps are too unequal for one, that.
Peak vertex(const ContactMoment& a, const ContactMoment& b, const ContactMoment& c) {
  const double before = b.t - a.t, after = c.t - b.t;
  if (std::max(before, after) > most_unequal * std::min(before, after)) return {b.t, b.force.norm()};
  const double fa = a.force.norm(), fb = b.force.norm(), fc = c.force.norm();
  const double left = (fb - fa) / (b.t - a.t), right = (fc - fb) / (c.t - b.t), bend = (right - left) / (c.t - a.t);
  if (!(bend < 0) || !std::isfinite(bend)) return {b.t, fb};
  const double slope = left + bend * (b.t - a.t), dt = -slope / (2 * bend);  // at b
  return {b.t + dt, fb + slope * dt + bend * dt * dt};
}

// Nothing pushes in between.
Touch together(const Touch& a, const Touch& b) {
  const Touch& higher = a.peak_force >= b.peak_force ? a : b;
  return {a.start, b.end, higher.peak_force, higher.peak_time, a.impulse + b.impulse};
}

}  // namespace

void TouchLog::open(const ContactMoment& now) {
  const double start = met_ ? *met_ : last_.empty() ? now.t : crossing(last_.back(), now);
  met_.reset();
  touching_ = true;
  impulse_at_start_ = last_.empty() ? now.impulse : last_.back().impulse;
  touches_.push_back({start, std::numeric_limits<double>::infinity(), 0, start, Vector3d::Zero()});
}

void TouchLog::close(const ContactMoment& now) {
  touching_ = false;
  touches_.back().end = crossing(last_.back(), now);
  touches_.back().impulse = now.impulse - impulse_at_start_;
}

void TouchLog::look_for_peak(const ContactMoment& now) {
  Touch& touch = touches_.back();
  const double force = now.force.norm();
  if (force > touch.peak_force) touch.peak_force = force, touch.peak_time = now.t;
  if (last_.size() < 2) return;
  const ContactMoment &a = last_[0], &b = last_[1];
  if (b.force.norm() < touch.peak_force * (1 - 1e-12) || b.force.norm() < a.force.norm() || !(force < b.force.norm()))
    return;
  const Peak peak = vertex(a, b, now);
  if (peak.force > touch.peak_force) touch.peak_force = peak.force, touch.peak_time = peak.t;
}

void TouchLog::add(const ContactMoment& now) {
  if (!touching_ && now.least_gap < 0) open(now);
  if (touching_) {
    look_for_peak(now);
    touches_.back().impulse = now.impulse - impulse_at_start_;
    if (!(now.least_gap < 0)) close(now);
  }
  if (last_.size() == 2) last_.erase(last_.begin());
  last_.push_back(now);
}

std::vector<Touch> TouchLog::touches() const {
  std::vector<Touch> merged;
  for (Touch next : touches_) {
    const double now = last_.back().t;
    const auto length = [&](const Touch& touch) { return std::min(touch.end, now) - touch.start; };
    while (!merged.empty()) {
      const Touch& before = merged.back();
      if (next.start - before.end > short_separation * std::max(length(before), length(next))) break;
      next = together(before, next);
      merged.pop_back();
    }
    merged.push_back(next);
  }
  return merged;
}

ContactHistory opposite(const ContactHistory& of_first) {
  ContactHistory other{-of_first.force, -of_first.impulse, VectorXd::Zero(of_first.stored.size()),
                       VectorXd::Zero(of_first.dissipated.size()), of_first.touches};
  for (Touch& touch : other.touches) touch.impulse = -touch.impulse;
  return other;
}

}  // namespace mb
