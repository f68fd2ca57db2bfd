// The touch that the maps of steps in contact are about: where the first body meets what it meets first, and what that
// place sees of the modes of both.
#pragma once

#include "cases/contract/touchdown.h"
#include "harness/analysis/contact_stability.h"
#include "harness/analysis/contact_variants.h"

namespace mb {

// As seen in the world.
struct Encounter {
  Meeting meeting;
  Vector3d normal;  // [-] of what is met, towards the body
  double mass;      // [kg] of both bodies, the reduced one
};

// Throws std::invalid_argument where the first body meets nothing.
Encounter first_encounter(const Scene& scene);

// The first r elastic modes of both bodies and their rigid ones, the layer `factor` times as stiff as the scene's.
PressedModes pressed(const ContactVariants& variants, const Encounter& encounter, int r, double factor);

// What static shapes of both bodies add to the compliance of that area, in balance as they are with the force on it:
//
//   c = psi^T K_s^-1 psi,   psi = mean over |X - X_c| < a of Psi^T n
//
// over samples that face what is met. None of bases that have none.
std::vector<StaticYield> static_yields(const FloatingBases& bases, const Encounter& encounter);

// What is slower than its weight alone would have it be, at rest above all, is thrown at that, `flight` [s] before it
// touches.
void throw_at_least(Scene& scene, const Encounter& encounter, double flight);

}  // namespace mb
