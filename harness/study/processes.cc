#include "harness/study/processes.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "reports/held_signals.h"

namespace mb {

namespace {

// Those that run, for signal handlers; 0: none. Written by the thread that forks and waits alone.
std::array<std::atomic<pid_t>, most_processes> running{};
std::atomic<pid_t> beside{0};  // another program, in one of them or in the first
static_assert(std::atomic<pid_t>::is_always_lock_free);

// Its number is free for others once it has been waited for: nobody may signal it by then.
int exit_code(int slot) {
  const pid_t process = running[static_cast<std::size_t>(slot)];
  siginfo_t ended{};
  while (waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT) != 0 && errno == EINTR) continue;
  running[static_cast<std::size_t>(slot)] = 0;
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return 3;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 3;
}

[[noreturn]] void be_process(int i, const std::function<int(int)>& work) {
  int code = 3;
  try {
    code = work(i);
  } catch (const std::exception& failure) {
    std::cerr << failure.what() << '\n';
  }
  std::cout.flush(), std::cerr.flush();
  _exit(code);  // destructors of what the parent owns are the parent's
}

// The process that now runs in the slot; 0 in the process itself, -1 where there can be no more.
pid_t forked(int slot) {
  const HeldSignals held;
  const pid_t parent = getpid(), process = fork();
  if (process > 0) running[static_cast<std::size_t>(slot)] = process;
  if (process != 0) return process;
  for (auto& other : running) other = 0;  // those are the parent's
  beside = 0;
  // A parent that has ended before this call would never be missed.
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != parent) _exit(3);
  return 0;
}

}  // namespace

int in_processes(int n, const std::function<int(int)>& work) {
  if (n > most_processes) throw std::invalid_argument("at most " + std::to_string(most_processes) + " processes");
  std::cout.flush(), std::cerr.flush(), std::fflush(nullptr);  // or children would print it again
  int n_running = 0, error = 0;
  for (; n_running < n && error == 0; ++n_running) {
    const pid_t process = forked(n_running);
    if (process == 0) be_process(n_running + 1, work);
    if (process < 0) {
      error = errno;
      break;
    }
  }
  int code = 0;
  for (int slot = 0; slot < n_running; ++slot) code = std::max(code, exit_code(slot));
  if (error != 0) throw std::system_error(error, std::generic_category(), "fork");
  return code;
}

Reached::Reached(pid_t process) { beside = process; }
Reached::~Reached() { beside = 0; }

void signal_processes(int signal) {
  const int before = errno;
  for (const auto& process : running)
    if (const pid_t one = process; one > 0) kill(one, signal);
  if (const pid_t one = beside; one > 0) kill(one, signal);
  errno = before;
}

}  // namespace mb
