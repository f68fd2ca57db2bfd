// Tables of the contest of collision detection (collision_contest.h) and the verdict on claim C11; their columns stand
// in analyses.h.
#pragma once

#include "harness/analysis/analysis.h"
#include "harness/analysis/collision_contest.h"

namespace mb {

std::vector<Finding> collision_cost(const Shape& body, const CollisionSizes& sizes);

// Of costs ~ m^analytic against ~ m^rival where m = n, cheaper from `crossover` on (NaN: nowhere), the smallest size
// tried. An exponent counts as the claimed one, 1 or 2, within 0.15: times have logarithms, caches and noise in them.
std::string collision_verdict(double analytic, double rival, double crossover, double smallest);

}  // namespace mb
