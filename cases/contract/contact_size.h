// How large a contact gets, estimated before anything is simulated; what scales, meshes and `auto` follow.
//
//   point   Hertz's impact with 1/R = sqrt(k_1 k_2), k_i the curvatures of the gap at the first touch
//   flat    a bar's: delta = v l/c, T = 2 l/c, F = rho c v A,   c = sqrt(E/rho), l the body's height, A = V/l
//   auto    k_n = 100 E*/a: the layer adds E*/(pi k_n a), 0.3 %, to the approach of a sphere
//
//   strike  a ball of mass m and radius R by law `hertz` on a body too heavy to move: k = 4/3 E* sqrt(R), E* of both
//
// Of two bodies E* is that of both, 1/E* = 1/E*_1 + 1/E*_2, and so is the mass m, unless supports hold one of them.
//
// Without speed, at rest, the weight takes the part of the impact; where nothing is known to press, an approach of a
// thousandth of the extent. Orthotropic bodies count with the largest modulus.
#pragma once

#include "cases/scene/scene.h"

namespace mb {

struct ContactSize {
  double modulus;    // E* [Pa]
  double radius;     // a [m] of the contact
  double approach;   // delta [m] of body and obstacle
  double speed;      // v [m/s], of the impact or of what weight alone brings about
  double duration;   // T [s]
  double force;      // F [N] largest
  double stiffness;  // k_n [Pa/m] as stated by the pair, or `auto`; of law hertz k [N/m^1.5]
  double curvature;  // 1/R [1/m] of the gap, geometric mean; 0: flat
};

// At the body's point X [m, body frame], which meets the obstacle at `speed` [m/s] >= 0 along its normal; `at`: the gap
// there, with the body's frame in `pose`. partner: the body that is met, in whose frame all this is; nullptr: an
// obstacle. gravity [m/s^2]: what the one has more of it than the other.
ContactSize contact_size(const Body& body, const ContactPair& pair, const Vector3d& X, const Pose& pose, const Gap& at,
                         double speed, const Vector3d& gravity, const Body* partner = nullptr);

// Throws std::invalid_argument for an obstacle that is no ball that strikes.
ContactSize strike_size(const Body& body, const ContactPair& pair, const Obstacle& obstacle);

}  // namespace mb
