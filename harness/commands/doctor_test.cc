#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cases/json/json.h"
#include "harness/commands/bytes.h"
#include "harness/commands/colour.h"
#include "harness/commands/machine.h"
#include "harness/commands/told_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

namespace fs = std::filesystem;
using test::told;
using ::testing::HasSubstr;

Machine quiet() {
  return {.n_cores = 4,
          .n_threads = 1,
          .blas = "OpenBLAS 0.3.21, 1 thread",
          .libraries = "deal.II 9.4.1, GNU 12.2.0 Release",
          .page = true,
          .clock_resolution = 3e-8,
          .kernel_time = 1e-4,
          .kernel_spread = 0.003,
          .kernel_busy = 1,
          .load = 0.1,
          .governor = "performance",
          .memory = 1.6e10,
          .disk = 1e11,
          .writable = true};
}

std::vector<std::string> warnings(const Machine& machine) {
  std::vector<std::string> names;
  for (const Diagnosis& d : diagnose(machine)) {
    EXPECT_EQ(d.ok, d.advice.empty()) << d.name;
    if (!d.ok) names.push_back(d.name);
  }
  return names;
}

TEST(DoctorTest, AQuietMachineIsWell) { EXPECT_THAT(warnings(quiet()), ::testing::IsEmpty()); }

TEST(DoctorTest, WhatTheMachineDoesNotTellIsNoWarning) {
  Machine silent = quiet();
  silent.load = silent.memory = silent.disk = std::nullopt;
  silent.governor = std::nullopt;
  EXPECT_THAT(warnings(silent), ::testing::IsEmpty());
}

TEST(DoctorTest, EachFaultIsNamedAlone) {
  const auto fault = [](const auto& change) {
    Machine machine = quiet();
    change(machine);
    return warnings(machine);
  };
  using ::testing::ElementsAre;
  EXPECT_THAT(fault([](Machine& m) { m.n_cores = 1; }), ElementsAre("cores"));
  EXPECT_THAT(fault([](Machine& m) { m.blas = "reference BLAS (slow)"; }), ElementsAre("BLAS"));
  EXPECT_THAT(fault([](Machine& m) { m.libraries = "GNU 12.2.0 Debug"; }), ElementsAre("libraries"));
  EXPECT_THAT(fault([](Machine& m) { m.page = false; }), ElementsAre("report page"));
  EXPECT_THAT(fault([](Machine& m) { m.clock_resolution = 1e-3; }), ElementsAre("clock resolution"));
  EXPECT_THAT(fault([](Machine& m) { m.kernel_spread = 0.2; }), ElementsAre("clock noise"));
  EXPECT_THAT(fault([](Machine& m) { m.kernel_busy = 0.5; }), ElementsAre("core kept"));
  EXPECT_THAT(fault([](Machine& m) { m.load = 8; }), ElementsAre("load average"));
  EXPECT_THAT(fault([](Machine& m) { m.governor = "powersave"; }), ElementsAre("frequency governor"));
  EXPECT_THAT(fault([](Machine& m) { m.memory = 1e9; }), ElementsAre("free memory"));
  EXPECT_THAT(fault([](Machine& m) { m.disk = 1e6; }), ElementsAre("disk"));
  EXPECT_THAT(fault([](Machine& m) { m.writable = false; }), ElementsAre("disk"));
  EXPECT_THAT(fault([](Machine& m) { m.kernel_spread = std::nan(""); }), ElementsAre("clock noise"));
}

void file(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

TEST(DoctorTest, ReadsWhatTheSystemTells) {
  const ScratchFolder root;
  file(root / "proc/loadavg", "1.25 0.5 0.1 2/345 6789\n");
  file(root / "proc/meminfo", "MemTotal: 100 kB\nMemAvailable:    2000 kB\n");
  file(root / "proc/self/status", "Name:\tx\nCpus_allowed_list:\t0-2,5,8-9\n");
  file(root / "sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "powersave\n");
  const Machine machine = examine(root / "results/not/yet", root.path());
  EXPECT_EQ(machine.n_cores, 6);
  EXPECT_EQ(machine.load, 1.25);
  EXPECT_EQ(machine.memory, 2000 * 1024.0);
  EXPECT_EQ(machine.governor, "powersave");
  EXPECT_TRUE(machine.writable);
  EXPECT_GT(machine.disk.value_or(0), 0);
  EXPECT_GT(machine.clock_resolution, 0);
  EXPECT_GT(machine.kernel_time, 0);
  EXPECT_GE(machine.kernel_spread, 0);
  // A control group's limit is less than what the machine has.
  file(root / "sys/fs/cgroup/memory.max", "1500\n");
  file(root / "sys/fs/cgroup/memory.current", "1000\n");
  EXPECT_EQ(examine(root.path(), root.path()).memory, 500);
  file(root / "sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(examine(root.path(), root.path()).memory, 2000 * 1024.0);
}

TEST(DoctorTest, NonsenseFromTheSystemIsNotKnown) {
  const ScratchFolder root;
  file(root / "proc/loadavg", "none\n");
  file(root / "proc/meminfo", "MemAvailable: lots\n");
  file(root / "occupied", "a file where a folder should be");
  const Machine machine = examine(root / "occupied", root.path());
  EXPECT_FALSE(machine.load);
  EXPECT_FALSE(machine.memory);
  EXPECT_FALSE(machine.governor);
  EXPECT_FALSE(machine.writable);
}

TEST(DoctorTest, TellsATableAndJsonWithoutColour) {
  const ScratchFolder folder;
  const auto table = told(folder.path(), [](const Console& c) { return doctor_command({}, c); });
  EXPECT_EQ(table.code, 0);
  for (const char* name : {"cores", "threads", "BLAS", "libraries", "clock noise", "load average", "disk"})
    EXPECT_THAT(table.out, HasSubstr(name));
  EXPECT_THAT(table.out, ::testing::Not(HasSubstr("\x1b")));
  EXPECT_THAT(table.err, HasSubstr("warning"));
  const auto said = told(folder.path(), [](const Console& c) { return doctor_command({.json = true}, c); });
  const Json json = parse_json(said.out);
  EXPECT_EQ(json["diagnoses"].size(), diagnose(quiet()).size());
  for (const Json& d : json["diagnoses"]) EXPECT_EQ(d["verdict"] == "ok", d["advice"] == "");
}

TEST(ColourTest, IsPaintedOnlyWhereAsked) {
  EXPECT_EQ(yellow("x", false), "x");
  EXPECT_EQ(yellow("x", true), "\x1b[33mx\x1b[0m");
  EXPECT_FALSE(shows_colour(std::ostringstream()));
}

TEST(BytesTest, ThreeDigits) {
  EXPECT_EQ(bytes(0), "0 B");
  EXPECT_EQ(bytes(999), "999 B");
  EXPECT_EQ(bytes(999.6), "1.00 kB");
  EXPECT_EQ(bytes(12'345), "12.3 kB");
  EXPECT_EQ(bytes(999'600), "1.00 MB");
  EXPECT_EQ(bytes(123e9), "123 GB");
  EXPECT_EQ(bytes(5e15), "5000 TB");
}

}  // namespace
}  // namespace mb
