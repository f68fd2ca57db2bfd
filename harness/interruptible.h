// Ends a run in good order on Ctrl-C, on SIGTERM and where its terminal is closed: the first such signal is told,
// passed on to the run's processes (study/processes.h) and asked for between jobs, the second ends the program at once.
#pragma once

#include <array>

namespace mb {

// While it is there. What was ignored before stays so: as nohup has it of SIGHUP, and a shell's `&` of SIGINT. One at a
// time.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  std::array<void (*)(int), 3> before_{};
};

bool interrupted();  // since the last Interruptible was made

}  // namespace mb
