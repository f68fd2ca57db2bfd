// Work spread over processes: libraries that keep state of their own (ARPACK, HDF5) run in each without knowing of the
// others.
#pragma once

#include <functional>

namespace mb {

// work(i) for i = 1 ... n, each in a process of its own, forked from here; what it returns is its exit code. Waits for
// all and returns the largest code; a process that ends by a signal counts as 3. No other thread may run meanwhile.
int in_processes(int n, const std::function<int(int)>& work);

}  // namespace mb
