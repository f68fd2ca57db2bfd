// eigensolve_comparison [--repeats N] [--splits N] [--python PROGRAM]
//
// The lowest modes of the free cylinder (bodies.h) by this suite, by SLEPc and by SciPy, on the same matrices, one
// after the other in every repeat: factor included, gate and matrices not. Other arguments are SLEPc's: -eps_ncv 90.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "benchmarks/bodies.h"
#include "benchmarks/npy.h"
#include "benchmarks/slepc.h"
#include "harness/measure.h"
#include "mechanics/algebra/threads.h"
#include "modal/bases/eigenmodes.h"

namespace mb {
namespace {

constexpr int n_modes = 30, n_rigid = 6;
constexpr double tolerance = 1e-10;  // [-]

struct Arguments {
  int repeats = 5, splits = 4;
  std::string python = MB_PYTHON;
};
Arguments arguments(int argc, char** argv) {
  Arguments result;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string key = argv[i];
    if (key == "--repeats") result.repeats = std::stoi(argv[i + 1]);
    if (key == "--splits") result.splits = std::stoi(argv[i + 1]);
    if (key == "--python") result.python = argv[i + 1];
  }
  if (result.repeats < 1 || result.splits < 1) throw std::invalid_argument("repeats and splits are at least 1");
  return result;
}

struct Contestant {
  std::string name = {};
  std::vector<double> times = {};  // [s]
  VectorXd lambda = {};            // [1/s^2] n_modes, ascending
};

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

// This suite's modes, the rigid ones as zeros.
void run_ours(Contestant& ours, const System& system) {
  ElasticModes modes;
  ours.times.push_back(
      seconds([&] { modes = elastic_modes(system, n_modes - n_rigid, shifted_factor(system, cylinder_shift)); }));
  ours.lambda = VectorXd::Zero(n_modes);
  ours.lambda.tail(n_modes - n_rigid) = modes.lambda.head(n_modes - n_rigid);
}

void run_slepc(Contestant& slepc, const System& system, const SlepcSession& session) {
  slepc.times.push_back(
      seconds([&] { slepc.lambda = session.nearest(system.K, system.M, n_modes, cylinder_shift, tolerance); }));
}

// Its own clock: the program's start and reading are not counted. False where it could not run.
bool run_scipy(Contestant& scipy, const std::filesystem::path& folder, const std::string& python) {
  const std::string command = fmt::format("'{}' '" MB_SCIPY_SCRIPT "' '{}' {} {} {}", python, folder.string(), n_modes,
                                          cylinder_shift, tolerance);
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
  double time = 0;
  if (!output || std::fscanf(output.get(), "%lf", &time) != 1) return false;
  scipy.lambda.resize(n_modes);
  for (double& lambda : scipy.lambda)
    if (std::fscanf(output.get(), "%lf", &lambda) != 1) return false;
  scipy.times.push_back(time);
  return true;
}

// How many of the true eigenvalues are not among those found.
int n_missed(const VectorXd& truth, const VectorXd& found) {
  int missed = 0;
  Index j = 0;
  for (const double lambda : truth) {
    if (j < found.size() && std::abs(found[j] - lambda) <= 1e-6 * std::max(std::abs(lambda), 1e-3))
      ++j;
    else
      ++missed;
  }
  return missed;
}

void print(const std::vector<Contestant>& contestants, const VectorXd& truth) {
  const double ours = median(contestants.front().times);
  fmt::print("{:12} {:>10} {:>10} {:>10} {:>12} {:>8}\n", "", "median [s]", "least [s]", "most [s]", "ours/theirs",
             "missed");
  for (const Contestant& c : contestants) {
    if (c.times.empty()) {
      fmt::print("{:12} {:>10}\n", c.name, "not found");
      continue;
    }
    const auto [least, most] = std::minmax_element(c.times.begin(), c.times.end());
    fmt::print("{:12} {:10.3f} {:10.3f} {:10.3f} {:12.2f} {:8}\n", c.name, median(c.times), *least, *most,
               ours / median(c.times), n_missed(truth, c.lambda));
  }
}

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "eigensolve-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void compare(const Arguments& wanted, const SlepcSession& session) {
  const auto model = cylinder(wanted.splits);
  const System& system = model->system();
  const TemporaryFolder folder;
  write_npy(folder.path(), "K", system.K);
  write_npy(folder.path(), "M", system.M);
  fmt::print("{} unknowns, {} modes, {}\n", system.M.rows(), n_modes, blas_description());
  Contestant ours{"modalbench"}, slepc{"SLEPc"}, scipy{"SciPy"};
  bool with_scipy = true;
  for (int repeat = 0; repeat < wanted.repeats; ++repeat) {
    run_ours(ours, system);
    if (has_slepc()) run_slepc(slepc, system, session);
    with_scipy = with_scipy && run_scipy(scipy, folder.path(), wanted.python);
  }
  // The gate, untimed: residuals, orthonormality, and the count, which no mode can hide from.
  const Modes gated = lowest_modes(system, n_modes - n_rigid, cylinder_shift);
  print({ours, slepc, scipy}, gated.omega.head(n_modes).array().square());
}

}  // namespace
}  // namespace mb

int main(int argc, char** argv) try {
  // For the child, and for libraries that read it late; our own is told below.
  for (const char* name : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "OMP_THREAD_LIMIT"}) setenv(name, "1", 1);
  const mb::Arguments wanted = mb::arguments(argc, argv);
  const mb::SlepcSession session(&argc, &argv);
  mb::use_one_thread();
  mb::compare(wanted, session);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "eigensolve_comparison: {}\n", error.what());
  return 1;
}
