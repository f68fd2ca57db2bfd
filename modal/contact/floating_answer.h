// A body of a scene with contact in its modes, made ready: where it may touch is sampled on its exact surface, graded
// towards each first touch, and the motion is that of modal/contact/impact_motion.h.
#pragma once

#include "cases/contract/linear.h"
#include "cases/contract/modes.h"
#include "cases/contract/touchdown.h"
#include "modal/contact/impact_motion.h"

namespace mb {

// What does not depend on integrator and step; made once for a basis.
struct FloatingBasis {
  std::shared_ptr<const Scene> scene;
  FloatingBody body;
  BodyState start;
  Regression geometry;                          // of the elastic modes by polynomials: what the contact sees of them;
                                                // of none for bodies of beam and plate theory
  ShapeBounds bounds;                           // of these polynomials
  Matrix3Xd points;                             // [m] evaluation points, body frame
  MatrixXd displacement, strain;                // of elastic modes at the points: 3 p x r, 6 p x r
  MatrixXd static_displacement, static_strain;  // of static shapes
};

// static_contact: with the static shapes of each contact, pressures on discs about the first touch (contact_shapes.h).
FloatingBasis floating_basis(const Model& model, const Modes& modes, bool static_contact);

// Makes a reduction of a scene with contact answer in the floating frame; does nothing to others. The model must
// outlive it.
void answer_in_contact(Reduction& reduction, const Model& model, const Modes& modes, bool static_contact);

// step [s] > 0, of steps in contact.
ImpactPlan impact_plan(const FloatingBasis& basis, ContactScheme scheme, double step);

// As Reduction::in_contact. The time step of the settings is the step in contact.
std::unique_ptr<Prepared> prepare_floating(std::shared_ptr<const FloatingBasis> basis, const Integrator& integrator,
                                           const Settings& settings);

}  // namespace mb
