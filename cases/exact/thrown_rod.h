// The closed form `rod-on-wall`: a box or cylinder without Poisson effect, thrown flat on a rigid plane and not
// spinning, one axis of it along the plane's normal: the waves of rod_impact.h from the first touch on, straight flight
// before and along the plane. Complete: displacement, strain, force, impulse, touch. No gravity.
#pragma once

#include "cases/exact/exact.h"

namespace mb {

ExactSolution thrown_rod();

}  // namespace mb
