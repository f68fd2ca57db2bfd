// Which full-order runs deserve a repeated timing: those which no other run beats in both error and time.
#pragma once

#include <string>
#include <vector>

#include "cases/contract/record.h"

namespace mb {

// Of the records of one case: runs that were timed once (no spread) and lie on the front of online time against the
// error in any of the three norms (displacement, strain, surface; against `finer` or `exact`), with a third of slack in
// time for the noise of one run. Errors count as speed-ups count them: as the truth's bar where they are below it, for
// equal error; as the target that error and bar together are within.
std::vector<std::string> dear_front(const std::vector<Record>& records);

}  // namespace mb
