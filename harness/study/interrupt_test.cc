// Ctrl-C, and how to go on after it.
#include <gmock/gmock.h>

#include <atomic>
#include <csignal>

#include "harness/commands/commands.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/study/catalogue_test.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

TEST(InterruptCases, IsToldOnceAndHeardBetweenTruths) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  // One of the two truths under way raises the signal: the two that are left are not begun.
  static std::atomic<bool> raised;
  raised = false;
  const Catalogue catalogue = with_sundials([](const System& system, const Settings& settings, double duration) {
    if (!raised.exchange(true)) std::raise(SIGINT);
    return default_catalogue().integrator("sundials").prepare(system, settings, duration);
  });
  const Said said = modalbench(scratch.path(), {"run", "case.toml"}, catalogue);
  EXPECT_EQ(said.code, 130);
  EXPECT_THAT(said.err, HasSubstr("finishing"));
  EXPECT_EQ(said.err.find("finishing"), said.err.rfind("finishing"));
  EXPECT_THAT(said.err, HasSubstr("0 runs done"));
  const auto truths = fs::directory_iterator(scratch / "results/truth");
  EXPECT_LE(std::distance(begin(truths), end(truths)), 2);
  EXPECT_EQ(modalbench(scratch.path(), {"run", "case.toml"}).code, 0);  // the next run knows nothing of it
}

TEST(InterruptCases, TheCommandThatGoesOnCanBePasted) {
  const ScratchFolder scratch;
  RunCommandOptions options;
  options.cases = {written(scratch / "my case's.toml", small_case())};
  options.store = scratch / "s D";
  options.overrides = {"modal.modes=4"};
  options.interrupted = [] { return true; };
  std::ostringstream out, err;
  EXPECT_EQ(run_command(options, default_catalogue(), {out, err}), 130);
  EXPECT_THAT(err.str(), HasSubstr("To go on:\n  modalbench run '" + (scratch / "my case").string() +
                                   "'\\''s.toml' --store '" + options.store + "' --set modal.modes=4\n"));
  options.again = true;
  EXPECT_EQ(run_command(options, default_catalogue(), {out, err}), 130);
  EXPECT_THAT(err.str(), HasSubstr("To start over, as --again says:"));
  EXPECT_THAT(err.str(), HasSubstr(" --again\n"));
}

}  // namespace
}  // namespace mb
