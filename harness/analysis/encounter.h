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

// The impact on a layer `factor` times as stiff as the scene's: that of elastic bodies without one (contact_size.h), or
// of rigid ones on the layer alone, whichever is wider and longer:
//
//   flat    T = pi sqrt(m/(k A))
//   round   m v^2/2 = pi k g^3/(3 c),   a^2 = 2 g/c <= 1/c^2,   T by impact_on_square_law,   c the curvature
struct ImpactOnLayer {
  double stiffness;  // k [Pa/m]
  double radius;     // a [m] of the contact
  double duration;   // T [s]
};
ImpactOnLayer impact_on_layer(const Encounter& encounter, double factor);

// The first r elastic modes of both bodies and their rigid ones, kappa = k pi a^2.
PressedModes pressed(const ContactVariants& variants, const Encounter& encounter, int r, const ImpactOnLayer& impact);

// What static shapes of both bodies add to the compliance of that area, in balance as they are with the force on it:
//
//   c = psi^T K_s^-1 psi,   psi = mean over |X - X_c| < a of Psi^T n
//
// a [m] over samples that face what is met. None of bases that have none.
std::vector<StaticYield> static_yields(const FloatingBases& bases, const Encounter& encounter, double a);

// What is slower than its weight alone would have it be, at rest above all, is thrown at that, `flight` [s] before it
// touches.
void throw_at_least(Scene& scene, const Encounter& encounter, double flight);

}  // namespace mb
