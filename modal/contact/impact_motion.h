// The whole motion of floating bodies among rigid obstacles and each other: flight in closed form to the first touch of
// surfaces, steps while any touches, flight again.
//
//   flight -- next_touch --> steps h from that very time -- no sample presses and the gap grows --> flight
//
// No step is taken in flight, but where rotation and modes are coupled or loads act (coupled_flow.h), and no contact is
// evaluated where bodies cannot meet.
#pragma once

#include <span>
#include <vector>

#include "mechanics/system/system.h"
#include "modal/contact/contact_step.h"
#include "modal/contact/modal_bounds.h"

namespace mb {

struct ImpactPlan {
  FloatingBody body;
  Shape shape;               // whose surface touches
  PolynomialBasis geometry;  // the elastic modes, r: what carries the surface in flight
  ShapeBounds bounds;        // of these
  BodyState start;           // at t = 0
  ContactScheme scheme;
  double step;  // h [s] > 0
  // false: what the body meets is among its modes, and no surface tells when: steps all the way from t = 0.
  bool flies = true;
};

struct FlightBegun {
  double start; /* [s] */
  BodyState from;
};

struct ImpactMotion {
  std::vector<BodyState> states;     // at the times asked for; valid ones
  ContactHistory contact;            // at the same times
  VectorXd energy;                   // [J] mechanical and stored
  std::vector<FlightBegun> flights;  // whose end was searched for
  Work work;  // steps: in contact and of coupled flight; load evaluations: of contact, in closed form or steps
  Status status = Status::ok;
};

// times [s] ascending, >= 0. Of bodies that meet each other scheme and step are those of the first; each gets its own
// states, forces and energy, what is stored and lost between two counting with the one whose samples meet the other;
// work and flights are those of all, with the first.
std::vector<ImpactMotion> impact_motions(std::span<const ImpactPlan> plans, const VectorXd& times);
ImpactMotion impact_motion(const ImpactPlan& plan, const VectorXd& times);

}  // namespace mb
