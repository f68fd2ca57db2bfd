// Superquadrics (Barr 1981, IEEE Computer Graphics and Applications 1(1), 11-23):
//
//   D(x) = [ (|x/a1|^(2/e2) + |y/a2|^(2/e2))^(e2/e1) + |z/a3|^(2/e1) ]^e1,   inside where D < 1
//
// The gauge N = sqrt(D) is a norm: with p = 2/e2 and q = 2/e1, both >= 1, the q-norm of (p-norm of (x/a1, y/a2), z/a3).
// Hence N(c x) = |c| N(x), x / N(x) is the surface point on the ray through x, and every superquadric with exponents in
// [0.1, 2] is convex. e = 2 makes edges (octahedra, double cones), e = 1 ellipses, e = 0.1 almost boxes.
//
// Every function throws std::invalid_argument where a semi-axis is not in [1e-100, 1e100] m or an exponent not in
// [0.1, 2]. No finite x makes a NaN; one that is not finite does.
#pragma once

#include "mechanics/geometry/shape.h"

namespace mb {

double inside_outside(const Superquadric& body, const Vector3d& x);  // D [-] >= 0; beyond 1.8e308 infinite
double gauge(const Superquadric& body, const Vector3d& x);           // N [-] >= 0

// N and its derivatives; those of D are 2 N grad N and 2 (grad N grad N^T + N grad grad N). Three cases have no
// derivative: at the centre all are 0; on an edge (e = 2) the gradient is the mean of both sides; where coordinates
// are 0 and e > 1 curvature is infinite, where r = |(x/a1, y/a2)|_p is 0 and e1 = 1 it depends on the side one comes
// from. There x/(a1 r), y/(a2 r), r/N and z/(a3 N) count as at least 1e-9 in negative powers, (x, y) = 0 as x/a1 =
// y/a2.
struct GaugeDerivatives {
  double value;             // N [-]
  Vector3d gradient;        // [1/m]
  Eigen::Matrix3d hessian;  // [1/m^2] symmetric, positive semidefinite, hessian x = 0; like 1 / |x|
};
GaugeDerivatives gauge_derivatives(const Superquadric& body, const Vector3d& x);

// Outward unit normal [-] of the surface N = const through x; at the centre +z.
Vector3d outward_normal(const Superquadric& body, const Vector3d& x);

// Principal curvatures of the surface N = const through x, positive where it bends away from the normal (sphere: 1/R).
// Finite as the Hessian above; at the centre all are 0.
struct PrincipalCurvatures {
  Eigen::Vector2d values;                  // [1/m] ascending, >= 0
  Eigen::Matrix<double, 3, 2> directions;  // [-] orthonormal, tangent to the surface
};
PrincipalCurvatures principal_curvatures(const Superquadric& body, const Vector3d& x);

// int x^i y^j z^k over the body [m^(3+i+j+k)], exact; 0 where a power is odd. With m = i+1, n = j+1, l = k+1
//   8 a1^m a2^n a3^l / (p q^2) B(m/p, n/p) Gamma((m+n)/q) Gamma(l/q) / Gamma((m+n+l)/q + 1)
// (Dirichlet's integral twice; the beta functions of Jaklic, Leonardis & Solina 2000, Segmentation and Recovery of
// Superquadrics, sect. 2.3). Powers in [0, 40], else std::invalid_argument.
double moment(const Superquadric& body, int i, int j, int k);

// Over the surface, by a double exponential rule; relative errors below 1e-12 (against a rule of half the step).
struct SurfaceMoments {
  double area;      // [m^2]
  Vector3d second;  // [m^4] of x^2, y^2, z^2
  double first;     // [m^3] of z; 0 unless tapered
};
SurfaceMoments surface_moments(const Superquadric& body);

}  // namespace mb
