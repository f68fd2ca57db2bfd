// The program as a process of its own, which a test may kill, starve or start twice.
#pragma once

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mb {

class Process {
 public:
  // Starts the program with these words in `folder`; its output goes to files below `folder`. It ignores no
  // signal, whatever this process does. prepare is called in it before the program begins: limits, another user.
  Process(const std::filesystem::path& folder, const std::vector<std::string>& words,
          const std::function<void()>& prepare = {});
  ~Process();  // kills it where it still runs
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void send(int signal) const;
  void send_to_group(int signal) const;  // of which it must be the leader
  bool ends_within(double seconds);      // whether it has ended by then
  int code();                            // waits; the exit code, or minus the signal that ended it
  double most_memory();                  // waits; [byte] resident at the peak, its children's, too
  double most_memory_of_its_own();       // waits; [byte] looked at every ms: no pages of files, which the system may
                                         // take from it and give back at any time
  std::string out() const, err() const;
  std::vector<pid_t> children() const;  // that it has forked and that run now
  bool handles(int signal) const;       // by a function of its own, no longer by what the system has it do

 private:
  bool reap(int options);  // whether it has ended

  std::filesystem::path out_, err_;
  pid_t process_;
  int status_ = 0;
  long most_resident_ = 0;  // [KiB]
  bool ended_ = false;
};

bool metis_takes_signals();  // of the program as it was built

bool is_running(pid_t process);  // there, and not dead and merely not waited for

}  // namespace mb
