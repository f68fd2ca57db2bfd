// First touch of surfaces in continuous time: of a body in flight, x(X, t), and a rigid obstacle that stands still,
//
//   the earliest t in [t0, t1] with   m(t) = min over X of gap(x(X, t)) = 0
//
// X runs over the exact surface of the body's shape, not over samples of it. None is missed: m > 0 is proved for whole
// intervals of time (first_touch_certificate.h has the proof), by steps of the second order that end just before m = 0;
// what is left is a root of m, whose slope is known: m' = normal . v at the nearest X (Danskin 1967, The Theory of
// Max-Min; the envelope theorem).
//
// With the tolerance tol, all gaps but for rounding:
//   hit      m passes 0 and goes on to fall below -tol; t is the root. The body is outside, m > tol/2, on all of
//            [t0, t - bracket], and bracket <= tol / |m'(t)| unless the budget below ran out.
//   grazing  m turns within [-tol, tol], or the search ends there; t is the time of its least value.
//   overlap  m(t0) < -tol: not in flight at all; t = t0. (Leaving: m(t0) < -depth.)
//   undecided  the budget is spent before an answer: a body that skims along the obstacle at a gap near the tolerance.
//            It does not touch before t, and may soon: who steps from then on misses nothing.
// Starting within the tolerance is touching: a hit or a grazing at once, unless the body is leaving.
//
// Leaving: the body has just been let go, m(t0) in [-depth, tol]. Until m has first exceeded tol, a touch counts only
// where m falls from the largest value that it has had by more than tol/2; this is a hit at the time of that value: t0
// of a body that moves down. What opens, at whatever speed, is no touch.
#pragma once

#include <optional>
#include <span>

#include "mechanics/contact/rigid_surface.h"
#include "mechanics/geometry/shape.h"

namespace mb {

// A material point in flight.
struct PointMotion {
  Vector3d x, v;              // [m], [m/s] in the world
  Eigen::Matrix3d F, F_rate;  // [-], [1/s] dx/dX and its time derivative: of a rigid body Q and Q'
};

// What holds for all X of the solid body and all t of an interval; | | of tensors is the greatest length that unit
// vectors give.
struct MotionBounds {
  Vector3d acceleration = Vector3d::Zero(); /* [m/s^2] any: gravity, say */
  double spread = 0;                        /* [m/s^2] >= |x_tt - acceleration|, finite */
  double bend = 0;                          /* [1/m] >= |x_XX|, finite; of a rigid body 0, as where u is linear in X */
  double bend_rate = 0;                     /* [1/(m s)] >= |x_tXX|, finite */
};

// x(X, t) = c(t) + Q(t) (X + u(X, t)), say: any motion that is twice differentiable, or once with a Lipschitz
// derivative, on the solid body.
class BodyMotion {
 public:
  virtual ~BodyMotion() = default;
  // Of many points [m] at one time [s]: what depends on t alone is found once. Written in place (out.size() =
  // X.size()): the inner loop allocates nothing. Calls with the same t follow each other.
  virtual void at(double t, std::span<const Vector3d> X, std::span<PointMotion> out) const = 0;
  virtual MotionBounds bounds(double ta, double tb) const = 0;  // ta <= tb [s]
};

struct TouchSearch {
  double t0, t1;            /* [s] finite, t0 <= t1 */
  double tolerance = 1e-12; /* [m] > 0; at least 512 roundings of the coordinates count (|x| + |v t| and the extent) */
  bool leaving = false;     /* the body starts at the surface and is expected to leave it */
  double depth = 1e-12;     /* [m] >= 0, how far it may then overlap */
  long budget = 2'000'000;  /* > 0, of evaluations of the motion; a hard search takes 1e4 */
};

struct FirstTouch {
  enum Kind { hit, grazing, overlap, undecided };
  Kind kind;
  double t;            // [s]
  Vector3d X, x;       // [m] the point of the body that touches, at rest and in the world; of several one
  Vector3d normal;     // [-] of the obstacle, outward
  double gap;          // [m] m(t)
  double bracket;      // [s] >= 0: for certain there is no touch before t - bracket
  long n_evaluations;  // of the motion of a point
};

// Nothing where the body stays clear. Throws std::invalid_argument for a search, shape or obstacle out of range and
// where the motion or its bounds are not finite (or a bound negative).
std::optional<FirstTouch> first_touch(const Shape& body, const BodyMotion& motion, const RigidSurface& obstacle,
                                      const TouchSearch& search);

// The same for many flights of one body: its surface is divided once, and the finer where it touches.
class TouchSurface;  // first_touch_surface.h
std::optional<FirstTouch> first_touch(TouchSurface& body, const BodyMotion& motion, const RigidSurface& obstacle,
                                      const TouchSearch& search);

}  // namespace mb
