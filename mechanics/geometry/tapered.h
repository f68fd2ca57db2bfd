// Tapered superquadrics (Barr 1984, Computer Graphics 18(3), 21-30): the superquadric D(X) <= 1 (superquadric.h)
// through
//
//   x = (c X, c Y, Z - z0),   c = 1 + k Z/a3,   z0 = 2 a3 k m / (1 + k^2 m),   m = mean of (Z/a3)^2 over D <= 1
//
// z0 puts the centroid into the origin: volume elements grow by c^2, and odd moments of the straight body are 0. Its
// section at Z is c (1 - |Z/a3|^q)^(1/q) times the p-norm's unit disc, so the body is convex where that radius f is
// concave in Z, which over Z < 0, t = |Z|/a3, k > 0 says
//
//   k t (q + 1 - 2 t^q) <= q - 1,   worst at t^q = 1/2:   |k| <= 2^(1/q) (q - 1)/q = 2^(e1/2) (1 - e1/2)
//
// (e1 = 1: 0.71; e1 = 0.1: 0.98; double cones, e1 = 2, not at all). Below 1 the map has an inverse on the body.
//
// Every function of a body throws std::invalid_argument as superquadric.h says, and for |k| above that bound.
#pragma once

#include "mechanics/geometry/shape.h"
#include "mechanics/geometry/superquadric.h"

namespace mb {

double largest_taper(double e1);                      // [-] the bound of |k| above
void require_valid(const TaperedSuperquadric& body);  // else std::invalid_argument

// The map, quadratic in X: x' = x + F (X' - X) + k/a3 (Z' - Z) (X' - X, Y' - Y, 0).
class Taper {
 public:
  explicit Taper(const TaperedSuperquadric& body);

  Vector3d apply(const Vector3d& X) const;                    // [m] x
  Vector3d inverse(const Vector3d& x) const;                  // [m] X; c below 1e-9 counts as that
  Eigen::Matrix3d gradient(const Vector3d& X) const;          // [-] F = dx/dX
  Vector3d area(const Vector3d& X, const Vector3d& n) const;  // [m^2] n dA there to that at x: c^2 F^-T n
  double factor(double Z) const { return 1 + rate_ * Z; }     // [-] c; det F = c^2
  double rate() const { return rate_; }                       // [1/m] k/a3
  double shift() const { return shift_; }                     // [m] z0

 private:
  double rate_, shift_;
};

// The unit-size profile in one half, h = +1 the upper: w = |Z|/a3 and r = (1 - w^q)^(1/q) by tau = log(r/w), the radius
// f = (1 + h k w) r and its slope df/dw r^(q-1), which is finite everywhere.
struct TaperedProfile {
  double w, r;           // [-] in [0, 1]
  double radius, slope;  // [-]
  double weight;         // [-] r^(q-1)
};
TaperedProfile tapered_profile(const TaperedSuperquadric& body, int half, double tau);
inline constexpr double most_tau = 40;  // there r or w is below rounding

// [m] largest n . (x, y) where f = 1.
double section_support(const TaperedSuperquadric& body, const Eigen::Vector2d& n);

Eigen::AlignedBox3d bounds(const TaperedSuperquadric& body);  // [m] exact

// The point farthest along w (first_touch_support.h): of f the slope that w asks for, by a root in tau.
Vector3d farthest(const TaperedSuperquadric& body, const Vector3d& w);

// As of the straight ones (superquadric.h), about the centroid; i, j in [0, 20], k in [0, 20].
double moment(const TaperedSuperquadric& body, int i, int j, int k);
SurfaceMoments surface_moments(const TaperedSuperquadric& body);

// Of the surface N(X(x)) = const through x [m]: outward unit normal, principal curvatures and |dN/dx| [1/m].
struct TaperedBend {
  double slope;
  Vector3d normal;
  PrincipalCurvatures curvatures;
};
TaperedBend tapered_bend(const TaperedSuperquadric& body, const Vector3d& x);

}  // namespace mb
