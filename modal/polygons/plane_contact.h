// A rigid convex body pressed by delta into the layer on a plane, p = k_n g per area of the body (mechanics/contact/
// law.h), seen through what a contender knows of its surface. With heights h over the deepest point, g = delta - h:
//
//   A = int_{g>0} dA,   F / k_n = int g dA,   U / k_n = int g^2/2 dA
//
//   samples      sum_i w_i f(g_i) over the i with g_i > 0: vertices with their areas, or points of a quadrature
//   curvatures   by the paraboloid h = (k_1 x^2 + k_2 y^2)/2 of the principal curvatures in the deepest point, K = k_1
//                k_2:   A = 2 pi delta / sqrt(K),   F / k_n = A delta/2,   U / k_n = A delta^2/6
//                (Pentland & Williams 1989, sect. 4.2, in words; exact on a sphere, where a zone of height delta has
//                the area 2 pi R delta by Archimedes)
//
// Hertz's pressure on a sphere, 2 E*/(pi R) sqrt(a^2 - r^2), is 2 E*/pi sqrt(2 g/R) with g of the depth delta/2: its
// resultant is that of sqrt(g) over half the depth (mechanics/contact/hertz.h).
#pragma once

#include "mechanics/types.h"

namespace mb {

struct PlaneContact {
  double area;    // A [m^2]
  double force;   // F / k_n [m^3]
  double energy;  // U / k_n [m^4]
  double depth;   // [m] of the deepest point known
  int n_touching; /* samples with g > 0; 0 of curvatures */
};

// Samples by height, ascending.
class HeightSamples {
 public:
  // height [m] over the deepest point of the exact surface, >= 0 but for rounding; weight [m^2] > 0. Throws
  // std::invalid_argument for what is not finite, weights not positive, or unlike numbers of both.
  HeightSamples(const VectorXd& height, const VectorXd& weight);

  Index size() const { return height_.size(); }
  double height(Index i) const { return height_[i]; }  // [m]
  double weight(Index i) const { return weight_[i]; }  // [m^2]
  PlaneContact at(double depth) const;                 // depth: delta [m], finite; <= 0: none touches
  double root_moment(double depth) const;              // int sqrt(g) dA [m^2.5]

 private:
  VectorXd height_, weight_;
};

// k_1, k_2 [1/m] >= 0: where one is 0 the paraboloid is a trough, all but depth infinite. depth [m] as above; throws
// std::invalid_argument for what is not finite or negative curvatures.
PlaneContact contact_by_curvatures(double k_1, double k_2, double depth);

}  // namespace mb
