// Modes that are stepped, against the closed form of the same modes: what is left is the error of their steps.
#include <gmock/gmock.h>

#include <map>

#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"

namespace mb {
namespace {

const char* const steppings = R"(
[[study.stepping]]
integrator = "newmark"
methods = ["static-correction"]
modes = [12]
time_steps = [1e-3, 5e-4]
[[study.stepping]]
integrator = "newmark"
methods = ["full"]
time_steps = [1e-3]
)";

class MarksOfSteps : public ::testing::Test {
 protected:
  // Displacement errors against the closed form of the same modes, by step.
  std::map<double, Record> marked() {
    fs::create_directory(scratch_ / "cases");
    written(scratch_ / "cases/small.toml", small_case_with(steppings));
    EXPECT_EQ(modalbench(scratch_.path(), {"run", "small", "--untimed"}).code, 0);
    std::map<double, Record> all;
    for (const Record& r : Store(scratch_ / "results").read_all_records().records) {
      if (r.truth != "same_modes") continue;
      EXPECT_EQ(r.contender.method, "static-correction") << "of modes that something steps alone";
      EXPECT_EQ(r.contender.integrator, "newmark");
      if (r.metric == "displacement-error") all[r.contender.settings.time_step] = r;
    }
    return all;
  }

 private:
  ScratchFolder scratch_;
};

// Average acceleration is of order 2: omega h is at most 0.13 in these modes, the next order (omega h)^2/12 of it.
TEST_F(MarksOfSteps, FallWithTheSquareOfTheStepAndLeaveNoTruncation) {
  const std::map<double, Record> error = marked();
  ASSERT_EQ(error.size(), 2u);
  const double ratio = error.at(1e-3).value / error.at(5e-4).value;
  EXPECT_NEAR(ratio, 4, 0.1);
  EXPECT_EQ(error.at(1e-3).status, "ok");
  EXPECT_TRUE(error.at(1e-3).error_bar.has_value()) << "that of the load";
}

}  // namespace
}  // namespace mb
