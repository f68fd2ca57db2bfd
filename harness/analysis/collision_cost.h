// Tables of the contest of collision detection (collision_contest.h) and the verdict on claim C11; their columns stand
// in analyses.h.
#pragma once

#include "harness/analysis/analysis.h"
#include "harness/analysis/collision_contest.h"

namespace mb {

std::vector<Finding> collision_cost(const Shape& body, const CollisionSizes& sizes);

// Of tests ~ m^analytic against ~ m^rival where m = n, and less time from `crossover` on (NaN: nowhere), the smallest
// size tried. An exponent counts as the claimed one, 1 or 2, within 0.15, for a tree's logarithm. Counts decide on
// exponents, because they are the same on every machine; perturbed: other work had the core while it was timed, and no
// crossover is known.
std::string collision_verdict(double analytic, double rival, double crossover, double smallest, bool perturbed);

}  // namespace mb
