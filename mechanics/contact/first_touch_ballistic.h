// First touch of a half-space in closed form, of a rigid body that does not turn, and of a sphere that may. The support
// point X* of the shape is the nearest all along, and with s = t - t0
//
//   m = c + b s + a s^2 / 2,   c = n . (position + Q X*) - offset,   b = n . velocity,   a = n . acceleration
//
// whose roots are taken without cancellation (Higham 2002, Accuracy and Stability of Numerical Algorithms, sect. 1.8).
// Answers are those of first_touch.h, where kinds, tolerance and leaving are defined; bracket is 0.
#pragma once

#include "mechanics/contact/first_touch.h"

namespace mb {

struct BallisticPath {
  Vector3d position, velocity, acceleration;  /* [m], [m/s] of the centre at t0, [m/s^2] constant */
  Eigen::Quaterniond orientation{1, 0, 0, 0}; /* [-] of unit length; of a spinning sphere any: X is in this frame */
};

// Throws std::invalid_argument where the obstacle is no half-space, the path is not finite, or for a search out of
// range.
std::optional<FirstTouch> first_touch(const Shape& body, const BallisticPath& path, const RigidSurface& half_space,
                                      const TouchSearch& search);

}  // namespace mb
