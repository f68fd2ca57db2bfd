// What is kept of a contender's answer.
#pragma once

#include <vector>

#include "cases/contract/method.h"
#include "cases/contract/record.h"

namespace mb {

// Whether the answer is one: what failed, or grew beyond its limit, leaves no numbers behind. marks: all of it.
bool is_answer(const Trajectory& answer, const std::vector<Record>& marks);

// Every n-th sample, without strains.
Trajectory thinned(const Trajectory& all, Index n);

}  // namespace mb
