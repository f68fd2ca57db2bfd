// How a small change of stiffness shows in a contact, of a light ball on a heavy beam: nearly on a wall, where Hertz's
// law alone decides, F ~ k^(2/5), duration ~ k^(-2/5), the impulse 2 m v by any k.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"

namespace mb {
namespace {

constexpr const char* light_ball = R"(schema = 1
name = "light-ball"
title = "t"
purpose = "p"
source = "s"
[time]
duration = 2e-4
frame_rate = 1e4
samples_per_second = 1e6
[[body]]
name = "beam"
theory = "euler-bernoulli"
[body.shape]
kind = "box"
size = [0.3, 0.08, 0.08]
[body.material]
youngs_modulus = 2e11
poissons_ratio = 0.3
density = 7960
[body.resolution]
degree = 1
cells = [39]
[[obstacle]]
name = "ball"
shape = { kind = "sphere", radius = 0.005 }
mass = 0.004
velocity = [0, 0, -0.01]
youngs_modulus = 2e11
poissons_ratio = 0.3
[[contact]]
body = "beam"
obstacle = "ball"
law = "hertz"
stiffness = "auto"
[truth]
relative_tolerance = 1e-8
finer = { degree = 1, cells = [79] }
coarser = { degree = 1, cells = [39] }
[study]
methods = ["eigenmodes"]
modes = [39]
contact_steps = [5e-7]
analyses = ["contact-stiffness"]
)";

TEST(ContactConditions, OfABallOnAHeavyBeamAreThoseOfHertz) {
  const ScratchFolder scratch;
  written(scratch / "light-ball.toml", light_ball);
  const Said said = modalbench(scratch.path(), {"run", "light-ball.toml", "--untimed"});
  ASSERT_EQ(said.code, 0) << said.err;
  int n_rows = 0;
  for (const Finding& finding : Store(scratch / "results").read_all_findings().findings) {
    if (finding.name != "contact-conditions") continue;
    const auto value = [&](const std::vector<FindingCell>& row, const std::string& column) {
      for (size_t j = 0; j < finding.columns.size(); ++j)
        if (finding.columns[j].name == column) return std::get<double>(row[j]);
      ADD_FAILURE() << "no column " << column;
      return std::nan("");
    };
    for (const auto& row : finding.rows) {
      if (value(row, "contact") > 1) continue;
      ++n_rows;
      EXPECT_NEAR(value(row, "condition of peak force"), 0.4, 0.02) << "a beam of 4,000 balls' mass gives way a little";
      EXPECT_NEAR(value(row, "condition of duration"), -0.4, 0.02);
      EXPECT_LT(std::abs(value(row, "condition of impulse")), 0.02);
      EXPECT_LT(std::abs(value(row, "condition of start")), 1e-6) << "they touch from the start";
    }
  }
  EXPECT_EQ(n_rows, 2) << "two ways of modes; full order has no second contact to tell of";
}

}  // namespace
}  // namespace mb
