#include "harness/metis_signals.h"

#if MB_METIS_TAKES_SIGNALS

#include <csignal>
#include <mutex>

extern "C" {

extern __thread int gk_cur_jbufs;  // of METIS: which of its 128 places to jump to this thread is at; -1: none
void gk_sigthrow(int signal);      // likewise: jumps there

int gk_sigtrap();
int gk_siguntrap();
}

namespace {

// A handler is of the whole process, and two threads may be in METIS at once.
std::mutex mutex;
int n_trapping = 0;
void (*before)(int) = SIG_DFL;

// Of an abort outside METIS nothing is made: it ends the program when this returns.
void on_abort(int signal) {
  if (gk_cur_jbufs >= 0) gk_sigthrow(signal);
}

}  // namespace

int gk_sigtrap() {
  constexpr int most_nested = 128;  // METIS's own bound
  if (gk_cur_jbufs + 1 >= most_nested) return 0;
  ++gk_cur_jbufs;
  const std::lock_guard lock(mutex);
  if (n_trapping++ == 0) before = std::signal(SIGABRT, on_abort);
  return 1;
}

int gk_siguntrap() {
  if (gk_cur_jbufs < 0) return 0;
  --gk_cur_jbufs;
  const std::lock_guard lock(mutex);
  if (--n_trapping == 0) std::signal(SIGABRT, before);
  return 1;
}

#endif

namespace mb {

void keep_signals_from_metis() {}

}  // namespace mb
