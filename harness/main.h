// The program `modalbench` as a function, so that an outside project can run it with a catalogue of its own.
#pragma once

#include "harness/catalogue.h"

namespace mb {

// Exit codes: 0 all checks hold, 1 a check fails, 2 usage, case file or output that cannot be written (a store, a
// report), 3 a solver failed or takes more memory than there is where the case does not expect it, now or when what is
// stored was computed, 130 interrupted.
int harness_main(int argc, char** argv, const Catalogue& catalogue);

}  // namespace mb
