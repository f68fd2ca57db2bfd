#include "harness/interruptible.h"

#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "harness/study/processes.h"

namespace mb {

namespace {

constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t interrupt_requested = 0;  // what a signal handler may touch
pid_t own_process = 0;

// Ctrl-C reaches every process of a terminal, `kill` one: the first passes it on and tells. Those forked for a run may
// thus meet it twice; they end with the first in any case (processes.h).
void on_interrupt(int) {
  if (getpid() != own_process) {
    interrupt_requested = 1;
    return;
  }
  if (interrupt_requested) std::_Exit(130);  // the second does not wait for the run at hand
  interrupt_requested = 1;
  signal_processes(SIGTERM);
  static constexpr char text[] = "finishing what is under way; Ctrl-C again ends at once\n";
  [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, text, sizeof text - 1);
}

}  // namespace

Interruptible::Interruptible() {
  interrupt_requested = 0;
  own_process = getpid();
  for (size_t i = 0; i < signals.size(); ++i) {
    before_[i] = std::signal(signals[i], on_interrupt);
    if (before_[i] == SIG_IGN) std::signal(signals[i], SIG_IGN);
  }
}

Interruptible::~Interruptible() {
  for (size_t i = 0; i < signals.size(); ++i) std::signal(signals[i], before_[i]);
}

bool interrupted() { return interrupt_requested != 0; }

}  // namespace mb
