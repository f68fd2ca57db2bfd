// Ends a run in good order on Ctrl-C, on SIGTERM and where its terminal is closed: the first such signal is told,
// passed on to the run's processes (study/processes.h) and asked for between jobs. Where a job takes longer than
// `patience`, or at a second signal, the program ends at once with its last words: what is finished is kept, what is
// under way is lost, as a store has nothing half-written (store/store.h).
#pragma once

#include <array>
#include <string>

namespace mb {

// While it is there. What was ignored before stays so: as nohup has it of SIGHUP, and a shell's `&` of SIGINT. One at a
// time.
class Interruptible {
 public:
  static constexpr unsigned patience = 5;  // [s] schedulers kill some ten after they have asked

  explicit Interruptible(const std::string& last_words);  // to the error output; up to 64 KB of them
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  std::array<void (*)(int), 3> before_{};
};

// From then on those signals end the program at once, with 130 and a word of it, where nothing Interruptible is there;
// what was ignored stays so.
void end_interrupted_on_signals();

bool interrupted();  // since the last Interruptible was made

}  // namespace mb
