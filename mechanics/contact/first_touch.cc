#include "mechanics/contact/first_touch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/contact/first_touch_certificate.h"
#include "mechanics/contact/first_touch_instant.h"
#include "mechanics/contact/first_touch_search.h"
#include "mechanics/contact/first_touch_support.h"

namespace mb {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class March {
 public:
  March(TouchSurface& body, const BodyMotion& motion, const RigidSurface& obstacle, const TouchSearch& search)
      : surface_(body),
        motion_(motion, search),
        obstacle_(obstacle),
        search_(search),
        descent_(surface_, motion_, obstacle),
        leaving_(search.leaving) {
    surface_.trim();
  }

  std::optional<FirstTouch> run();

 private:
  // What a front of time ends with.
  struct Front {
    std::optional<FirstTouch> touch;
    double step = 0;  // [s] the surface is clear so long; 0: no step could be proved
    bool spent = false;
  };
  PatchPoint first_guess();
  double tolerance(const NearPoint& p, double t) const;
  Front front(double t, double horizon);
  std::optional<FirstTouch> touch_at(double t);
  FirstTouch answer(FirstTouch::Kind kind, double t, const NearPoint& p, double clear) const;

  TouchSurface& surface_;
  CountedMotion motion_;
  const RigidSurface& obstacle_;
  const TouchSearch& search_;
  Descent descent_;
  NearPoint near_{};
  double before_ = 0;  // [s] the last front, up to which the surface is clear
  bool leaving_;
  double highest_ = -infinity;  // [m] m of the fronts before, while leaving
  Instant at_highest_{};
};

PatchPoint March::first_guess() {
  PatchPoint best{};
  double least = infinity;
  for (int k = 0; k < surface_.n_patches(); ++k) {
    const double g = descent_.at(surface_.cell(k).middle, search_.t0).gap.value;
    if (g < least) least = g, best = surface_.cell(k).middle;
  }
  return best;
}

double March::tolerance(const NearPoint& p, double t) const {
  return touch_tolerance(search_, p.motion.x.norm() + p.motion.v.norm() * std::abs(t) + circumradius(surface_.shape()) +
                                      obstacle_.pose.position.norm());
}

FirstTouch March::answer(FirstTouch::Kind kind, double t, const NearPoint& p, double clear) const {
  return {kind, t, p.X, p.motion.x, p.normal, p.gap.value, std::max(0.0, t - clear), motion_.n_evaluations()};
}

std::optional<FirstTouch> March::touch_at(double t) {
  const auto touch = touch_instant(descent_, {t, near_}, search_.t0, before_, search_.t1, tolerance(near_, t),
                                   circumradius(surface_.shape()));
  if (!touch) return std::nullopt;
  return answer(touch->kind, touch->instant.t, touch->instant.near, t);
}

March::Front March::front(double t, double horizon) {
  const bool first = t == search_.t0;
  PatchPoint start = near_.at;
  while (true) {
    if (motion_.spent()) return {answer(FirstTouch::undecided, t, near_, t)};
    near_ = descent_.nearest(start, t, leaving_ ? infinity : 0, search_.tolerance);
    const double m = near_.gap.value, tol = tolerance(near_, t);
    if (first && m < -std::max(tol, leaving_ ? search_.depth : 0)) return {answer(FirstTouch::overlap, t, near_, t)};
    const bool within = m <= tol, leaving = leaving_ && within, touching = !leaving_ && within;
    if (leaving && m <= highest_ - 0.5 * tol)
      return {answer(FirstTouch::hit, at_highest_.t, at_highest_.near, at_highest_.t)};
    if (touching && !first) return {touch_at(t)};
    const double level = leaving ? std::max(highest_, m) - tol : touching ? m - tol : 0.5 * tol;
    const double ahead = touching ? 0 : horizon;
    const MotionBounds bounds = motion_.bounds(t, t + ahead);
    const Proof proof = prove_clear({t, ahead, near_, level, bounds}, surface_, motion_, obstacle_);
    if (proof.lower >= 0) {
      start = surface_.cell(proof.lower).middle;
      continue;
    }
    if (touching) return {touch_at(t)};
    leaving_ = leaving;
    if (leaving && m > highest_) highest_ = m, at_highest_ = {t, near_};
    return {std::nullopt, proof.dt, proof.spent};
  }
}

std::optional<FirstTouch> March::run() {
  near_.at = first_guess();
  double t = search_.t0, horizon = search_.t1 - search_.t0;
  before_ = t;
  while (true) {
    const Front now = front(t, horizon);
    if (now.touch) return now.touch;
    if (t >= search_.t1) return std::nullopt;
    // While leaving half a step: there the concave lower bound is highest, at its end it is down at the level again.
    const bool to_the_end = now.step >= search_.t1 - t;
    const double step = leaving_ && !to_the_end ? 0.5 * now.step : now.step;
    // Where cells become too many the nearest point is followed instead, over what is left of its way: the bracket says
    // so.
    const double rate = near_.rate(), way = rate < 0 ? near_.gap.value / -rate : 0;
    const bool stuck = !(t + step > t), slow = now.spent && step < 0.3 * way;
    if (!leaving_ && (stuck || slow))
      if (auto touch = touch_at(t); touch && (stuck || touch->bracket < 4 * way)) return touch;
    if (stuck) return answer(FirstTouch::undecided, t, near_, t);
    before_ = t;
    t = to_the_end ? search_.t1 : t + step;
    horizon = std::min(search_.t1 - t, 4 * step);
  }
}

}  // namespace

std::optional<FirstTouch> first_touch(const Shape& body, const BodyMotion& motion, const RigidSurface& obstacle,
                                      const TouchSearch& search) {
  TouchSurface surface(body);
  return first_touch(surface, motion, obstacle, search);
}

std::optional<FirstTouch> first_touch(TouchSurface& body, const BodyMotion& motion, const RigidSurface& obstacle,
                                      const TouchSearch& search) {
  require_valid(search);
  return March(body, motion, obstacle, search).run();
}

}  // namespace mb
