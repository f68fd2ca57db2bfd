// What answers of full order among obstacles share: how a body comes to its first touch, and what is written down of
// contact, from the body's axes at t = 0, in which it is simulated from `start` on, to the world's.
#pragma once

#include "cases/contract/touchdown.h"
#include "mechanics/contact/touches.h"

namespace mb {

// x = c0 + Q0 (X + d(t) + u): closed-form flight until `start` [s], d(start) from then on.
struct Fall {
  Pose from;                   // c0, Q0
  bool free;                   // what is held stands still
  double start;                // [s]
  Vector3d velocity, gravity;  // in the body's axes

  Vector3d flown(double t) const;                                                 // d [m] at t <= start
  Pose frame() const { return {from.to_world(flown(start)), from.orientation}; }  // from start on
  // u, 3 p x n_t at points [m], in the body's axes -> x - X; of a body that is held, to the world's axes alone.
  MatrixXd placed(const MatrixXd& u, const Matrix3Xd& points, const VectorXd& t) const;
  // From a run's times, forces and axes; n_before: of n_t times, those before the start.
  ContactHistory in_world(const ContactHistory& run, Index n_before, Index n_t) const;
};
Fall fall_of(const Scene& scene, const Body& body, double start);  // start [s]; of what is held 0

// Errors are judged by what is met: of an obstacle that a rigid body would not meet, by the size of the first touch.
const ContactSize& size_for(const Touchdown& touchdown, const Meeting& meeting);

}  // namespace mb
