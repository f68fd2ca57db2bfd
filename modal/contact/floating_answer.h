// The answer of bodies in their modes and floating frames (floating_bases.h): their motion is that of
// modal/contact/impact_motion.h.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cases/contract/linear.h"
#include "modal/contact/floating_bases.h"
#include "modal/contact/impact_motion.h"

namespace mb {

// Makes a reduction of a scene with contact, or of free bodies of finite kinematics alone, answer in floating frames;
// does nothing to others. The model must outlive it.
void answer_in_frames(Reduction& reduction, const Model& model, std::span<const Modes> modes, bool corrected);

// step [s] > 0, of steps in contact. One a body.
std::vector<ImpactPlan> impact_plans(const FloatingBases& bases, ContactScheme scheme, double step,
                                     RotationCoupling rotation = RotationCoupling::rigid);

// As Reduction::in_contact. The time step of the settings is the step in contact; without contact there are none.
std::unique_ptr<Prepared> prepare_floating(std::shared_ptr<const FloatingBases> bases, const Integrator& integrator,
                                           const Settings& settings);

}  // namespace mb
