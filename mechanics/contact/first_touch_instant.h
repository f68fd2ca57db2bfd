// The least gap along time, m(t) and m'(t), near its root or its minimum; between front and root nothing is proved, the
// nearest point is followed.
#pragma once

#include "mechanics/contact/first_touch_descent.h"

namespace mb {

struct Instant {
  double t;                                      // [s]
  NearPoint near;                                // the nearest point then
  double gap() const { return near.gap.value; }  // [m] m
  double rate() const { return near.rate(); }    // [m/s] m'
};

struct TouchInstant {
  FirstTouch::Kind kind;
  Instant instant;
};

// What becomes of a surface that at `front` has come to the tolerance [m], up to t1 [s]; since `before` [s] it was
// clear; the motion is asked for in [t0, t1]. Nothing where it turns above the tolerance. size [m]: of the body.
std::optional<TouchInstant> touch_instant(const Descent& descent, const Instant& front, double t0, double before,
                                          double t1, double tolerance, double size);

}  // namespace mb
