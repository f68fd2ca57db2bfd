// Proof that a moving surface stays clear: gap(x(X, t + dt)) > level for every X of the body and 0 <= dt <= some step.
//
// 1. Obstacles are convex, and so is their gap: gap(x) >= g + n . (x - y) with the gap g and normal n at any point y.
// 2. For X within r of a point C of the (convex, hence solid) body, by Taylor with M = MotionBounds,
//      n . x(X, t+dt) >= n . (x_C + v_C dt) + w(dt) . (X - C) + min(0, n . M.acceleration) dt^2/2
//                        - M.spread dt^2/2 - (M.bend + M.bend_rate dt) r^2/2,   w(dt) = (F_C + F'_C dt)^T n
// 3. The body is convex, so all its X have
//      support:  w . (X - C) >= -h(-w) - w . C,   h the support function (first_touch_support.h)
//      cone:     w . (X - C) >= -|w + sum_i c_i N_i| |X - C|,   N_i the body's outward normals at C, any c_i >= 0
//    Support serves edges, corners and flats of the body: there it is sharp in one stroke; the cone serves cells beside
//    the nearest point, which it excludes from a distance of about two cell sizes on.
// 4. The sum of either with 2 is a concave function G(dt): h and |.| are convex. So G(0) > level and G(dt) > level
// prove
//    G > level in between.
//
// The whole body (C its centre, r its circumradius), with the plane of the nearest point, is tried first: of a rigid
// body this is sharp, as separating planes of convex bodies are. Where bend spoils it, cells of the surface are split
// until each is proved, by the plane of the nearest point or by its own. The error of a cell at the nearest point is of
// second order in its size, in smooth and in flat places and, by the support, at edges; so some ten cells a level are
// split.
#pragma once

#include "mechanics/contact/first_touch_descent.h"

namespace mb {

struct Proof {
  double dt;           // [s] >= 0: the gap stays above the level up to there
  int lower = -1;      // instead: a cell whose middle lies nearer than what was thought the nearest point
  bool spent = false;  // the cells became too many: dt is what they allow
};

// What holds at one time.
struct Clearance {
  double t, horizon;  // [s]; >= 0, over which the bounds hold
  const NearPoint& nearest;
  double level;  // [m] < nearest.gap.value
  const MotionBounds& bounds;
};

// From t on, for dt up to the horizon. The surface gets the cells that are looked at.
Proof prove_clear(const Clearance& now, TouchSurface& surface, CountedMotion& motion, const RigidSurface& obstacle);

}  // namespace mb
