#include <fmt/format.h>

#include "harness/commands/bytes.h"
#include "harness/commands/machine.h"

namespace mb {

namespace {

// A factor of 129,987 degrees of freedom, the largest mesh of the shipped cases, takes 2.6 GB; two truths run at once.
constexpr double enough_memory = 4e9;  // [byte]
constexpr double enough_disk = 1e9;    // [byte] several full profiles
constexpr double quiet_spread = 0.02;  // [-] speed-ups are told to two digits
constexpr double least_busy = 0.98;    // [-] likewise
constexpr double fine_clock = 1e-6;    // [s] a hundredth of the shortest online times, about 1e-4 s

Diagnosis good(const std::string& name, const std::string& value) { return {name, value, true, ""}; }
Diagnosis judged(const std::string& name, const std::string& value, bool ok, const std::string& advice) {
  return {name, value, ok, ok ? "" : advice};
}

Diagnosis of_cores(const Machine& m) {
  return judged("cores", std::to_string(m.n_cores), m.n_cores >= 2,
                "two or more keep timed runs apart from the rest of the system: do nothing else meanwhile");
}

Diagnosis of_blas(const Machine& m) {
  return judged("BLAS", m.blas, m.blas.find("reference") == std::string::npos,
                "install OpenBLAS (Debian: libopenblas0-pthread): factors take a third of the time");
}

Diagnosis of_build(const Machine& m) {
  return judged("libraries", m.libraries, m.libraries.find(" Release") != std::string::npos,
                "times of a build that is not of type Release mean nothing: use the preset native or release");
}

std::vector<Diagnosis> of_clock(const Machine& m) {
  return {judged("clock resolution", fmt::format("{:.0f} ns", 1e9 * m.clock_resolution),
                 m.clock_resolution <= fine_clock, "short online times are not to be trusted on this machine"),
          judged("clock noise", fmt::format("{:.1f} % of {:.0f} us", 100 * m.kernel_spread, 1e6 * m.kernel_time),
                 m.kernel_spread <= quiet_spread,
                 "end other programs, plug a laptop in, or measure later: small speed-ups drown in this"),
          judged("core kept", fmt::format("{:.1f} % of the time", 100 * m.kernel_busy), m.kernel_busy >= least_busy,
                 "something else had the core meanwhile: end it before anything is timed")};
}

// This process itself may count as one in the mean of a minute.
Diagnosis of_load(const Machine& m) {
  if (!m.load) return good("load average", "not known");
  return judged("load average", fmt::format("{:.2f}", *m.load), *m.load <= std::max(1.0, m.n_cores - 0.5),
                "other programs want the cores: wait or end them before anything is timed");
}

Diagnosis of_governor(const Machine& m) {
  if (!m.governor) return good("frequency governor", "not readable, as on virtual machines: clock noise tells instead");
  return judged("frequency governor", *m.governor, *m.governor == "performance",
                "the core's frequency may change within a run: `cpupower frequency-set -g performance` as root");
}

Diagnosis of_memory(const Machine& m) {
  if (!m.memory) return good("free memory", "not known");
  return judged("free memory", bytes(*m.memory), *m.memory >= enough_memory,
                "the full profile may not fit: run the quick one, or --jobs 1");
}

Diagnosis of_disk(const Machine& m) {
  if (!m.writable) return {"disk", "results cannot be written there", false, "name another folder with --store"};
  if (!m.disk) return good("disk", "free space not known");
  return judged("disk", bytes(*m.disk) + " free", *m.disk >= enough_disk,
                "make room: `modalbench clean` says what results are no longer needed");
}

}  // namespace

std::vector<Diagnosis> diagnose(const Machine& m) {
  std::vector<Diagnosis> all = {of_cores(m), good("threads", fmt::format("{}, on both sides", m.n_threads)), of_blas(m),
                                of_build(m)};
  for (Diagnosis& diagnosis : of_clock(m)) all.push_back(std::move(diagnosis));
  for (const Diagnosis& diagnosis : {of_load(m), of_governor(m), of_memory(m), of_disk(m)}) all.push_back(diagnosis);
  all.push_back(judged("report page", m.page ? "built in" : "not built", m.page,
                       "install Node with npm and build again: until then report.html is not written"));
  return all;
}

}  // namespace mb
