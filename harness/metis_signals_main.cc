// METIS, which orders what CHOLMOD factorises, takes SIGTERM and SIGABRT for itself while it works, to leave by longjmp
// where it fails; a SIGTERM from outside then jumps out of any thread, or is lost. Its two functions in this program's
// version, which the loader prefers to the library's: SIGABRT alone, which it raises where memory ends, is trapped, and
// SIGTERM stays what interruptible.h makes of it.
#include <array>
#include <csignal>
#include <cstddef>

extern "C" {

extern __thread int gk_cur_jbufs;  // of METIS: which of its 128 places to jump to this thread is at; -1: none
void gk_sigthrow(int signal);      // likewise: jumps there

int gk_sigtrap();
int gk_siguntrap();
}

namespace {

using Handler = void (*)(int);
thread_local std::array<Handler, 128> before;

}  // namespace

int gk_sigtrap() {
  const auto next = static_cast<std::size_t>(gk_cur_jbufs + 1);
  if (next >= before.size()) return 0;
  ++gk_cur_jbufs;
  before[next] = std::signal(SIGABRT, gk_sigthrow);
  return 1;
}

int gk_siguntrap() {
  if (gk_cur_jbufs < 0) return 0;
  std::signal(SIGABRT, before[static_cast<std::size_t>(gk_cur_jbufs)]);
  --gk_cur_jbufs;
  return 1;
}
