// Runs past the limit of their step, through the program: named, without a number, without a trajectory.
#include <gmock/gmock.h>

#include <cmath>

#include "cases/contract/status.h"
#include "cases/json/record_json.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

// Twelve modes of a body of jelly, without damping: their limit is about 2/130 s.
const char* const steppings = R"(
[[study.stepping]]
integrator = "symplectic-euler"
methods = ["static-correction"]
modes = [12]
time_steps = [1e-3, 2.5e-2]
[[study.stepping]]
integrator = "explicit-euler"
methods = ["static-correction"]
modes = [12]
time_steps = [1e-5, 1e-2]
)";

class UnstableRunCases : public ::testing::Test {
 protected:
  ScratchFolder scratch;
  Said run(const std::string& duration = "1.0") {
    fs::create_directory(scratch / "cases");
    std::string all = small_case_with(steppings);
    const std::string briefly = "[time]\nduration = 0.1";
    all.replace(all.find(briefly), briefly.size(), "[time]\nduration = " + duration);
    written(scratch / "cases/small.toml", all);
    return modalbench(scratch.path(), {"run", "small"});
  }
};

TEST_F(UnstableRunCases, LeaveRecordsWithoutValuesAndNoTrajectory) {
  const Said said = run();
  EXPECT_EQ(said.code, 0) << said.err;  // a result, no failure
  EXPECT_THAT(said.err, HasSubstr("unstable, no trajectory kept"));
  const Store store(scratch / "results");
  int n_unstable = 0, n_ok = 0;
  for (const Record& record : store.read_all_records().records) {
    const auto& [method, integrator, resolution, settings] = record.contender;
    const bool beyond = (integrator == "symplectic-euler" && settings.time_step > 1e-2) ||
                        (integrator == "explicit-euler" && settings.time_step > 1e-4);
    const bool unknown =
        record.metric == "probe-von-mises" && record.truth == "finer";  // known no better than the stress there
    if (beyond || !unknown) {
      EXPECT_EQ(record.status, beyond ? "unstable" : "ok") << record.metric << " " << integrator << settings.time_step;
    }
    EXPECT_EQ(std::isnan(record.value), beyond || unknown) << record.metric;
    if (record.contender.integrator == "sundials") continue;  // the truth's own marks
    EXPECT_EQ(store.has_trajectory(record.run), !beyond) << record.metric << " " << integrator << settings.time_step;
    ++(beyond ? n_unstable : n_ok);
    if (!beyond) {
      EXPECT_NO_THROW(store.read_trajectory(record.run));
    }
  }
  EXPECT_GT(n_unstable, 0);
  EXPECT_GT(n_ok, n_unstable);
}

// Four steps past the limit, and ten of explicit Euler: what grows by theory was hardly moved.
TEST_F(UnstableRunCases, AreNamedByTheoryAloneWhereNothingIsSeenOfIt) {
  EXPECT_EQ(run("0.1").code, 0);
  const Store store(scratch / "results");
  int n = 0;
  for (const Record& record : store.read_all_records().records) {
    EXPECT_NE(record.status, "unstable");
    if (record.status == "ok") continue;
    EXPECT_EQ(record.status, unstable_by_theory);
    EXPECT_FALSE(store.has_trajectory(record.run));
    ++n;
  }
  EXPECT_GT(n, 0);
}

// What is stored stays stored, and who reads the store misses nothing.
TEST_F(UnstableRunCases, AreCompleteWithoutATrajectory) {
  ASSERT_EQ(run().code, 0);
  EXPECT_THAT(run().err, HasSubstr("0 runs done, 8 found"));
  EXPECT_EQ(modalbench(scratch.path(), {"report"}).code, 0);
}

// What is thrown higher and higher stays finite, and has ever more energy in play.
TEST_F(UnstableRunCases, AreThoseThatContactFeeds) {
  written(scratch / "small.toml", bouncing_case("contact_steps = [1e-3, 1.2e-2]"));
  const Said said = modalbench(scratch.path(), {"run", "small.toml", "--untimed"});
  EXPECT_EQ(said.code, 0) << said.err;
  int n_unstable = 0, n_ok = 0;
  for (const Record& record : Store(scratch / "results").read_all_records().records) {
    if (record.metric == "load-error") continue;  // of the load alone
    const bool beyond = record.contender.integrator == "exact" && record.contender.settings.time_step > 1e-2;
    EXPECT_EQ(record.status == "unstable", beyond) << record.metric << record.status;
    ++(beyond ? n_unstable : n_ok);
  }
  EXPECT_GT(n_unstable, 0);
  EXPECT_GT(n_ok, n_unstable);
}

}  // namespace
}  // namespace mb
