// The program `modalbench` as a function, so that an outside project can run it with a catalogue of its own.
#pragma once

#include "harness/catalogue.h"

namespace mb {

// Exit codes: 0 all checks hold, 1 a check fails, 2 usage or case file, 3 a solver failed where the case does not
// expect it, 130 interrupted.
int harness_main(int argc, char** argv, const Catalogue& catalogue);

}  // namespace mb
