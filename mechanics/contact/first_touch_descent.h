// The nearest point of a moving surface at one time, m(t) = min over X of f, f = gap(x(X, t)), by descent from a point:
//
//   f_a = w . X_a,   f_ab = X_a^T F^T H F X_b + (w . X_a)_b at fixed n,   w = F^T n
//
// n and H the gap's normal and Hessian, X_a the derivatives of the patch; Newton's method in the two parameters, the
// second part of f_ab by differences. At edges of a patch a parameter rests where f falls outwards (Bertsekas 1982,
// SIAM J. Control Optim. 20, projected Newton), unless it falls on in the patch beyond. The result is a local minimum;
// that nothing lies nearer is proved elsewhere.
//
// Superquadrics with e near 2 are almost sharp, f like |s|^1.04 beside an edge: no prey for Newton. What helps is the
// support point of -w, which is the nearest of a rigid body before a plane: it is tried after Newton's method, too.
//
// Above an edge of the obstacle normals turn by 1 / gap: at small gaps the rounding of x, 1e-17 m, blurs them. But to
// first order n + H F X_a dz_a is the normal at z + dz, however small Newton's step dz: the plane that separates both.
#pragma once

#include "mechanics/contact/first_touch.h"
#include "mechanics/contact/first_touch_surface.h"

namespace mb {

struct NearPoint {
  PatchPoint at;
  Vector3d X;          // [m]
  PointMotion motion;  // of X
  Gap gap;             // of the obstacle at motion.x
  Vector3d normal;     // [-] gap.normal, carried on to where Newton's next step would lead: see below
  double rate() const { return gap.normal.dot(motion.v); }  // [m/s] of f at fixed X
};

// The motion with its work counted and its answers looked at: std::invalid_argument where they are not finite.
class CountedMotion {
 public:
  CountedMotion(const BodyMotion& motion, const TouchSearch& search) : motion_(motion), search_(search) {}
  void at(double t, std::span<const Vector3d> X, std::span<PointMotion> out);
  MotionBounds bounds(double ta, double tb) const;
  long n_evaluations() const { return n_; }
  bool spent() const { return n_ > search_.budget; }

 private:
  const BodyMotion& motion_;
  const TouchSearch& search_;
  long n_ = 0;
};

class Descent {
 public:
  Descent(const TouchSurface& surface, CountedMotion& motion, const RigidSurface& obstacle)
      : surface_(surface), motion_(motion), obstacle_(obstacle) {}

  NearPoint at(const PatchPoint& point, double t) const;
  // Downhill from a point until the model promises less than a thousandth of what f lies above the level [m], or of the
  // tolerance [m].
  NearPoint nearest(const PatchPoint& start, double t, double level, double tolerance) const;
  NearPoint nearest(const PatchPoint& start, double t) const;  // until rounding ends it
  // The distance [m] of the point from the plane across p.normal that bears on the obstacle: the gap, unblurred.
  double plane_gap(const NearPoint& p) const;

 private:
  struct Model {
    Eigen::Vector2d slope;                // f_a
    Eigen::Matrix2d bend;                 // f_ab
    Eigen::Matrix<double, 3, 2> turning;  // H F X_a
    Eigen::Vector2d size;                 // |X_a|
    double steepness;                     // |w|
  };
  Model model(const NearPoint& p, double t) const;
  NearPoint newton(NearPoint p, double t, double level, double tolerance) const;
  std::optional<NearPoint> by_support(const NearPoint& p, double t) const;
  static NearPoint with_normal(NearPoint p, const Model& m, const Eigen::Vector2d& step);
  std::optional<NearPoint> beyond(const NearPoint& p, const Model& m) const;
  std::optional<NearPoint> lower(const NearPoint& p, const Model& m, const Eigen::Vector2d& step, double t) const;

  const TouchSurface& surface_;
  CountedMotion& motion_;
  const RigidSurface& obstacle_;
};

}  // namespace mb
