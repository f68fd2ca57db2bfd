// The bodies of a scene with contact in their modes, made ready: where they may touch is sampled on their exact
// surfaces, graded towards each first touch, and the motion is that of modal/contact/impact_motion.h.
#pragma once

#include <span>
#include <vector>

#include "cases/contract/linear.h"
#include "cases/contract/modes.h"
#include "cases/contract/touchdown.h"
#include "modal/contact/impact_motion.h"

namespace mb {

// What does not depend on integrator and step; made once for a basis.
struct FloatingBasis {
  std::shared_ptr<const Scene> scene;
  size_t place;  // of the body in the scene
  FloatingBody body;
  BodyState start;
  Regression geometry;                          // of the elastic modes by polynomials: what the contact sees of them;
                                                // of none for bodies of beam and plate theory
  ShapeBounds bounds;                           // of these polynomials
  Matrix3Xd points;                             // [m] evaluation points, body frame
  MatrixXd displacement, strain;                // of elastic modes at the points: 3 p x r, 6 p x r
  MatrixXd static_displacement, static_strain;  // of static shapes
  std::shared_ptr<const FullModel> full;
  MatrixXd Phi;  // n x r, of the mesh
};
using FloatingBases = std::vector<FloatingBasis>;  // of all bodies, in the scene's order

// modes: of each body. static_contact: with the static shapes of each contact, pressures on discs about the first touch
// (contact_shapes.h).
FloatingBases floating_bases(const Model& model, std::span<const Modes> modes, bool static_contact);

// Makes a reduction of a scene with contact answer in floating frames; does nothing to others. The model must outlive
// it.
void answer_in_contact(Reduction& reduction, const Model& model, std::span<const Modes> modes, bool static_contact);

// step [s] > 0, of steps in contact. One a body.
std::vector<ImpactPlan> impact_plans(const FloatingBases& bases, ContactScheme scheme, double step,
                                     RotationCoupling rotation = RotationCoupling::rigid);

// As Reduction::in_contact. The time step of the settings is the step in contact.
std::unique_ptr<Prepared> prepare_floating(std::shared_ptr<const FloatingBases> bases, const Integrator& integrator,
                                           const Settings& settings);

}  // namespace mb
