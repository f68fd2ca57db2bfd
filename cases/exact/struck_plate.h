// The closed form `zener-impact`: an elastic ball on a plate so large that its waves do not come back while it touches,
// as on an infinite one (zener_impact.h). At the scene's times the force; how the plate deforms away from the ball is
// not part of it: displacement and strain have no columns.
//
// The plate's rim: at its first images, half the shorter edge away to either side, the infinite plate has answered to
// the ball by a part of pi/2 - Si(x) in pi/2, x = l^2/(4 c T), c = sqrt(D/(rho h)), l the shorter edge and T the
// duration. It oscillates, and the force is smooth: x >= 15 leaves 1e-4 of the restitution, measured on plates of
// x = 2.7 to 44. Simply supported edges or others make no difference then.
#pragma once

#include "cases/exact/exact.h"

namespace mb {

ExactSolution struck_plate();

}  // namespace mb
