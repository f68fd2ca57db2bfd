#include "harness/study/grade.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/exact/exact.h"
#include "cases/exact/exact_test_scenes.h"
#include "cases/json/json.h"
#include "cases/json/record_json.h"
#include "harness/study/instability.h"

namespace mb {
namespace {

Trajectory scaled(Trajectory of, double by) {
  for (auto& body : of.bodies) body.displacement *= by, body.strain *= by;
  return of;
}

// A sphere whose truth moves as its closed form does, and `apart` of itself more on the coarser mesh.
struct TwoMeshes {
  Scene scene = sphere_scene();
  Trajectory exact =
      exact_solution("sphere-radial-pulse")
          .at(scene, evaluation_points(scene, scene.bodies[0]), VectorXd::LinSpaced(61, 0, 1) * scene.duration);
  TruthSet truth;

  explicit TwoMeshes(double apart) {
    truth.finer = truth.same_mesh = truth.loose = exact;
    truth.coarser = scaled(exact, 1 + apart);
  }
  Record error_of(double times) const {
    Record base;
    base.contender.method = "full-order";
    for (const Record& r : Grader(scene, truth, {true}, {}).marks(base, scaled(exact, times)))
      if (r.metric == "displacement-error" && r.truth == "finer") return r;
    ADD_FAILURE() << "no displacement-error";
    return {};
  }
};

// The truth may be s times what it is, |s - 1| <= d: the error of a times it is |a - s|/s, at most at s = 1 - d.
TEST(Grade, OfAnErrorRelativeToTheTruthTheBarHoldsThatOfTheTruthsSizeToo) {
  for (const double apart : {1e-3, 0.1, 0.6})
    for (const double a : {1.0, 1.5, 20.0}) {
      const double d = safety_of_meshes * apart;
      const Record error = TwoMeshes(apart).error_of(a);
      ASSERT_EQ(error.status, "ok") << apart;
      EXPECT_NEAR(error.value, a - 1, 1e-12 * a);
      ASSERT_TRUE(error.error_bar.has_value());
      EXPECT_NEAR(error.value + *error.error_bar, (a - (1 - d)) / (1 - d), 1e-9 * a) << apart << ", " << a;
    }
}

TEST(Grade, OfATruthThatMayBeZeroThereIsNoRelativeError) {
  const Record error = TwoMeshes(0.8).error_of(1.5);
  EXPECT_EQ(error.status, "undefined: what the truth may be off by is as large as what it has there");
  EXPECT_FALSE(error.error_bar.has_value());
  EXPECT_TRUE(to_json(error)["value"].is_null());
}

// A truth of which little is known tells all the same of an answer that ran away.
TEST(Grade, OfATruthThatMayBeZeroAnAnswerThatRanAwayIsUnstable) {
  const std::vector<Record> marks{TwoMeshes(0.8).error_of(1e6)};
  Integrator with_a_limit;
  with_a_limit.conditionally_stable = true;
  EXPECT_EQ(kept_limit(marks, with_a_limit, {}, 0), Limit::passed);
}

}  // namespace
}  // namespace mb
