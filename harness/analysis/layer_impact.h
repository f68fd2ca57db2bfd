// A rigid body flies into a layer on a plane, moving along the plane's normal alone:
//
//   delta'' = -(k_n/m) F(delta),   delta(0) = 0,   delta'(0) = v,   F = int g dA (modal/polygons/plane_contact.h)
//
// m and k_n drop out by tau = t sqrt(k_n/m) [1/m], in which all times here are: rates d delta/d tau are [m^2], F [m^3],
// and v^2/2 = U [m^4] at the greatest depth. The layer keeps all energy: whatever F(delta) is, the impulse of the whole
// impact is 2 m v. What a contender's force does to an impact shows in its duration, its peak, and in the impulse it
// has delivered by the time at which the exact body rests.
#pragma once

#include <functional>

#include "modal/polygons/plane_contact.h"

namespace mb {

struct LayerImpact {
  double duration;    // [1/m] of contact
  double peak_force;  // [m^3] F of the greatest depth
  double impulse;     // [m^2] v - v(t) at the time asked for
};

using ContactOfDepth = std::function<PlaneContact(double depth)>;

// Time [1/m] from touch to rest of the impact whose greatest depth [m] is given, to 1e-8 where F is smooth; its speed
// is v = sqrt(2 U) [m^2].
double time_to_rest(const ContactOfDepth& law, double greatest_depth);

// speed: v [m^2] > 0; until [1/m] >= 0. Of samples in closed form: between the heights of two samples the motion is
// harmonic. Throws std::invalid_argument where there are none, as for what is out of range.
LayerImpact impact_on_samples(const HeightSamples& samples, double speed, double until);

// F = c delta^2, as curvatures have it: c [m] > 0.
LayerImpact impact_on_square_law(double c, double speed, double until);

}  // namespace mb
