// METIS 5.1, which orders what CHOLMOD factorises, takes SIGTERM and SIGABRT for itself while it works, to leave by
// longjmp where it fails; a SIGTERM from outside then jumps out of any thread, or is lost. Its two functions in a
// version of ours, which the loader prefers to the library's: SIGABRT alone, which it raises where memory ends, is
// trapped, and SIGTERM stays what interruptible.h makes of it.
#pragma once

namespace mb {

// Does nothing: a program that calls it is linked with these two.
void keep_signals_from_metis();

}  // namespace mb
