// How the bodies of a scene, rigid as yet, come to their obstacles and to each other: what happens before anything
// deforms, in closed form, the same for every answer.
#pragma once

#include <limits>

#include "cases/contract/contact_size.h"
#include "mechanics/contact/law.h"

namespace mb {

// One contact of a body, as if it were alone: its first touch, or its nearest approach within the duration.
struct Meeting {
  size_t contact;  // place in scene.contacts
  double t;        // [s] of the first touch; infinity: none within the scene's duration
  Vector3d X;      // [m] body frame: where the body touches, or comes nearest; of an edge or a face the middle
  ContactSize size;
  Vector3d Y = Vector3d::Zero();  // [m] where another body is met, in its frame
};

struct Touchdown {
  double t = std::numeric_limits<double>::infinity();  // [s] of the first touch of all
  std::vector<Meeting> meetings;                       // in the scene's order; of the contacts that name this body
};

// Throws std::invalid_argument where the body starts within what it meets, deeper than 1e-9 of its extent, naming both
// and the depth. What strikes a body touches the middle of its top face at t = 0.
Touchdown touchdown(const Scene& scene, const Body& body);

// What touchdown would throw because of an overlap at t = 0; empty where there is none. Nothing is searched for.
std::string overlap_at_start(const Scene& scene, const Body& body);

// Where on a body its contacts are, whichever of the two bodies it is: X [m] in its frame, of meeting X or Y.
struct TouchedAt {
  Meeting meeting;
  Vector3d X;
};
std::vector<TouchedAt> touched_at(const Scene& scene, const Body& body);  // in the scene's order

PenaltyLaw law_of(const ContactPair& pair, const ContactSize& size);
const Obstacle& obstacle_of(const Scene& scene, const ContactPair& pair);  // throws std::out_of_range naming it
// The obstacle's surface in the world; of one that strikes, whose distance is among the unknowns, its tangent plane; of
// another body that of its shape at t = 0.
RigidSurface surface_met(const Scene& scene, const Body& body, const Meeting& meeting);

// An obstacle as seen from a frame: gap(seen, X) = gap(surface, frame.to_world(X)).
RigidSurface seen_from(const Pose& frame, const RigidSurface& surface);

}  // namespace mb
