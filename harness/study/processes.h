// Work spread over processes: libraries that keep state of their own (ARPACK, HDF5) run in each without knowing of the
// others.
#pragma once

#include <sys/types.h>

#include <functional>

namespace mb {

inline constexpr int most_processes = 256;

// work(i) for i = 1 ... n <= most_processes, each in a process of its own, forked from here; what it returns is its
// exit code. Waits for all and returns the largest code; a process that ends by a signal counts as 3. No other thread
// may run meanwhile. None outlives its parent, however that ends: the kernel kills it (PR_SET_PDEATHSIG). SIGINT,
// SIGTERM and SIGHUP wait while one is made, so that none misses a signal passed on.
int in_processes(int n, const std::function<int(int)>& work);

// While it is there signals passed on reach this child, too, one at most: another program that ends by them. Made
// before signals that were held while it was forked come again, it misses none.
class Reached {
 public:
  explicit Reached(pid_t process);
  ~Reached();
  Reached(const Reached&) = delete;
  Reached& operator=(const Reached&) = delete;
};

// Passes a signal on to all that run now. May be called by a signal handler.
void signal_processes(int signal);

}  // namespace mb
