// The surface of a superquadric where no coordinate is negative, by the logarithms of two ratios:
//
//   sigma = log(u/v),  tau = log(r/w)   with u = x/a1, v = y/a2, r = |(u, v)|_p, w = z/a3, |(r, w)|_q = 1
//   x = (a1 R C, a2 R S, a3 W),   grad N = (R' C'/a1, R' S'/a2, W'/a3)
//
// C = u/r, S = v/r, R = r, W = w and their duals C' = C^(p-1), ..., W' = W^(q-1). Barr's angles resolve the point only;
// next to an edge (p near 1) the normal turns while the point stands still to rounding, C = 0 and C' = e^((p-1) sigma),
// and in a flat (p large) it is the other way round. Logarithms resolve both. Lengths are in units of the largest
// semi-axis, exponents 2/e at least 1 + 1e-15: an edge is rounded by less than rounding.
#pragma once

#include "mechanics/geometry/shape.h"

namespace mb {

// Of a pair whose p-norm is 1: first = 1 / (1 + e^(-p l))^(1/p), second = e^(-l) first, the powers p - 1 (duals) and
// p (shares, which sum to 1) of both. All [-] in [0, 1].
struct Ratios {
  double first, second, dual_first, dual_second, share_first, share_second;
};
Ratios ratios(double l, double power);  // power = p - 1 > 0

struct ChartPoint {
  double sigma, tau;  // [-]
  Ratios across, along;
  Vector3d x;       // [-] on the surface
  Vector3d normal;  // [-] outward, of unit length
  double slope;     // |grad N|
};

// dx / dsigma = point_weight * point, d grad N / dsigma = gradient_weight * gradient, likewise by tau. The weights are
// powers of the lesser ratio, of which they also are (up to its share) the logarithmic derivatives; both may underflow.
struct ChartTangent {
  Vector3d point, gradient;
  double point_weight, gradient_weight;
  double point_part, gradient_part;  // the weights by their sum, known where that underflows, too
};

class OctantChart {
 public:
  explicit OctantChart(const Superquadric& body);

  ChartPoint at(double sigma, double tau) const;
  ChartPoint on_ray(const Vector3d& x) const;  // x / N(x), of x > 0
  ChartTangent by_sigma(const ChartPoint& at) const;
  ChartTangent by_tau(const ChartPoint& at) const;

  const double unit;              // [m] the largest semi-axis
  const Vector3d a;               // [-] semi-axes / unit
  const double power_p, power_q;  // [-] p - 1, q - 1, at least 1e-15
};

}  // namespace mb
