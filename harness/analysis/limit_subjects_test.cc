// What is looked at of a mesh whose modes are all known, the highest of them twice.
#include "harness/analysis/limit_subjects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/case_files.h"
#include "harness/analysis/context_test.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

Scene damped_scene() {
  std::string words = small_case();
  words.insert(words.find("[body.resolution]"), "[body.damping]\nbeta = 1e-5\n");
  words.replace(words.find("degree = 2"), 10, "degree = 1");
  const ScratchFolder folder;
  return read_toml(written(folder / "case.toml", words), default_catalogue().vocabulary());
}

// Kernels of the BLAS differ in which of the two is the higher; either way its limit must be run.
TEST(LimitSubjects, TheHighestModeIsRunWhicheverOfItsCopiesRoundingPutsFirst) {
  test::in_context(damped_scene(), {}, [](const AnalysisContext& context) {
    const int n_elastic = static_cast<int>(modal_body(context, 1).system.M.rows()) - 6;
    ModalBody body = modal_body(context, n_elastic);
    EXPECT_EQ(body.modes.size() - body.modes.n_rigid, n_elastic);
    double& highest = body.modes.omega(body.modes.size() - 1);
    const double known = highest;
    int n_limits = 0;
    for (const double off : {-3e-15, -3e-16, 0.0, 3e-16, 3e-15}) {
      highest = known * (1 + off);
      for (const Scheme& scheme : schemes()) {
        const SubjectLimit limit = limit_of(full_subjects(body).front(), scheme);
        if (!(limit.dt > 0 && std::isfinite(limit.dt))) continue;
        ++n_limits;
        EXPECT_TRUE(limit.mode.has_value()) << scheme.name << " " << off;
      }
    }
    EXPECT_GE(n_limits, 5 * 4) << "fewer than four explicit schemes had a limit";
  });
}

// Below it they have no shape here, and none is run in that of another.
TEST(LimitSubjects, OfTheLowerModesNoneIsRun) {
  test::in_context(damped_scene(), {}, [](const AnalysisContext& context) {
    const ModalBody body = modal_body(context, 8);
    const LimitSubject full = full_subjects(body).front();
    for (Index i = 0; i < full.omega.size(); ++i) EXPECT_EQ(full.mode(i).has_value(), i == full.omega.size() - 1) << i;
  });
}

// Where no step holds a mode the highest does not stand for it: one by which the highest is seen to grow may throw off
// another, damped far beyond critical.
TEST(LimitSubjects, WhereAnyStepGrowsTheHighestStandsForNoOther) {
  LimitSubject subject{};
  subject.omega = Eigen::Vector2d(1, 100);  // [rad/s]
  subject.zeta = Eigen::Vector2d(0, 0);
  const SteppedMode highest{100, 0, VectorXd::Unit(2, 1), VectorXd::Unit(2, 1)};
  subject.mode = [&](Index i) { return i == 1 ? std::optional(highest) : std::nullopt; };
  int n_without = 0;
  for (const Scheme& scheme : schemes()) {
    const SubjectLimit limit = limit_of(subject, scheme);
    if (limit.dt > 0) continue;
    ++n_without;
    EXPECT_EQ(limit.deciding, 0) << scheme.name;
    EXPECT_FALSE(limit.mode.has_value()) << scheme.name;
  }
  EXPECT_EQ(n_without, 2) << "explicit Euler, with the damping of its own and with exact damping";
}

}  // namespace
}  // namespace mb
