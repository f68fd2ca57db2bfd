#include "harness/commands/machine.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

#include "harness/measure.h"
#include "harness/study/memory.h"
#include "mechanics/algebra/threads.h"
#include "mechanics/types.h"
#include "reports/content.h"
#include "sources.h"

namespace mb {

namespace {

namespace fs = std::filesystem;

// Cpus_allowed_list of /proc/self/status, as "0-3,8": those which this process may use.
int n_usable_cores(const fs::path& root) {
  std::ifstream status(root / "proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("Cpus_allowed_list:")) continue;
    std::istringstream ranges(line.substr(line.find(':') + 1));
    int n = 0, first = 0, last = 0;
    while (ranges >> first) {
      last = first;
      if (ranges.peek() == '-') ranges.ignore() >> last;
      n += last - first + 1;
      ranges.ignore();
    }
    return n;
  }
  return static_cast<int>(std::thread::hardware_concurrency());
}

std::optional<std::string> first_word(const fs::path& file) {
  std::ifstream stream(file);
  std::string word;
  if (stream >> word) return word;
  return {};
}

std::optional<double> first_number(const fs::path& file) {
  const auto word = first_word(file);
  double value = 0;
  if (!word || std::from_chars(word->data(), word->data() + word->size(), value).ec != std::errc()) return {};
  return value;
}

// The folder itself or the nearest one above it that is there.
fs::path existing(const fs::path& folder) {
  std::error_code error;
  fs::path path = fs::absolute(folder, error).lexically_normal();
  while (!path.empty() && !fs::exists(path, error) && path.has_relative_path()) path = path.parent_path();
  return path;
}

// The shortest time that differs from none, in ten thousand runs of nothing.
double clock_resolution() {
  double shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 10'000; ++i)
    if (const double time = seconds([] {}); time > 0) shortest = std::min(shortest, time);
  return shortest;
}

// 20 products of a 200 x 200 matrix and a vector: in the cache of one core, no BLAS.
Timing time_kernel() {
  const MatrixXd A = MatrixXd::Constant(200, 200, 0.005);
  VectorXd x = VectorXd::Ones(200), y(200);
  return measure(
      [&] {
        for (int i = 0; i < 20; ++i) {
          y.noalias() = A * x;
          x.swap(y);
        }
      },
      20, 0.4);
}

}  // namespace

Machine examine(const fs::path& store, const fs::path& root) {
  const Timing kernel = time_kernel();
  const fs::path folder = existing(store);
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  return {.n_cores = n_usable_cores(root),
          .n_threads = 1,
          .blas = blas_description(),
          .libraries = sources::libraries,
          .page = page_available(),
          .clock_resolution = clock_resolution(),
          .kernel_time = kernel.median,
          .kernel_spread = kernel.spread / kernel.median,
          .kernel_busy = kernel.busy,
          .load = first_number(root / "proc/loadavg"),
          .governor = first_word(root / "sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"),
          .memory = available_memory(root),
          .disk = error ? std::nullopt : std::optional(static_cast<double>(space.available)),
          .writable = fs::is_directory(folder, error) && ::access(folder.c_str(), W_OK) == 0};
}

}  // namespace mb
