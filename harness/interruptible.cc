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
std::array<char, 65536> last_words;  // a handler may read no string
std::size_t n_last_words = 0;

void told(const char* text, std::size_t size) { [[maybe_unused]] const ssize_t n = ::write(STDERR_FILENO, text, size); }

[[noreturn]] void end_at_once(int) {
  told(last_words.data(), n_last_words);
  std::_Exit(130);  // the kernel ends processes of the run with it
}

// Ctrl-C reaches every process of a terminal, `kill` one: the first passes it on and tells. Those forked for a run may
// thus meet it twice; they end with the first in any case (processes.h).
void on_interrupt(int) {
  if (getpid() != own_process) {
    interrupt_requested = 1;
    return;
  }
  if (interrupt_requested) end_at_once(0);  // the second does not wait for the run at hand
  interrupt_requested = 1;
  signal_processes(SIGTERM);
  static constexpr char text[] = "finishing what is under way, for five seconds; Ctrl-C again ends at once\n";
  static_assert(Interruptible::patience == 5);
  told(text, sizeof text - 1);
  ::alarm(Interruptible::patience);
}

[[noreturn]] void end_interrupted(int) {
  static constexpr char text[] = "interrupted\n";
  told(text, sizeof text - 1);
  std::_Exit(130);
}

// What was ignored stays so.
void (*handled(int signal, void (*handler)(int)))(int) {
  const auto before = std::signal(signal, handler);
  if (before == SIG_IGN) std::signal(signal, SIG_IGN);
  return before;
}

}  // namespace

void end_interrupted_on_signals() {
  for (const int signal : signals) handled(signal, end_interrupted);
}

Interruptible::Interruptible(const std::string& words) {
  n_last_words = words.copy(last_words.data(), last_words.size());
  interrupt_requested = 0;
  own_process = getpid();
  for (size_t i = 0; i < signals.size(); ++i) before_[i] = handled(signals[i], on_interrupt);
  std::signal(SIGALRM, end_at_once);
}

Interruptible::~Interruptible() {
  ::alarm(0);
  std::signal(SIGALRM, SIG_DFL);
  for (size_t i = 0; i < signals.size(); ++i) std::signal(signals[i], before_[i]);
}

bool interrupted() { return interrupt_requested != 0; }

}  // namespace mb
