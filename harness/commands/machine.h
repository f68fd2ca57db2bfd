// What a machine is and how quiet it is, as far as it tells: what measured times depend on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mb {

struct Machine {
  int n_cores = 0;                      // that this process may use; 0: unknown
  int n_threads = 0;                    // of the timed parts
  std::string blas;                     // blas_description()
  std::string libraries;                // deal.II, SUNDIALS, Eigen, muParser, compiler and its flags
  bool page = false;                    // whether report.html was built in
  double clock_resolution;              // [s] shortest time told apart
  double kernel_time;                   // [s] median time of a fixed small kernel, about 1 ms
  double kernel_spread;                 // [-] half the distance of the quartiles, relative to the median
  double kernel_busy;                   // [-] processor time over wall-clock time while it was timed
  std::optional<double> load;           // [-] processes that wanted a core, mean of a minute
  std::optional<std::string> governor;  // of the processor's frequency: "performance", "powersave", ...
  std::optional<double> memory;         // [byte] available, the control group's limit included
  std::optional<double> disk;           // [byte] free where results are kept
  bool writable = false;                // whether results can be kept there
};

// store: the folder of results, which may not exist yet; root: where /proc and /sys are. Takes about half a second.
Machine examine(const std::filesystem::path& store, const std::filesystem::path& root = "/");

// One property with its verdict.
struct Diagnosis {
  std::string name, value;
  bool ok;
  std::string advice;  // what to do; empty where ok
};
std::vector<Diagnosis> diagnose(const Machine& machine);

}  // namespace mb
