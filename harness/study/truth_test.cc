#include "harness/study/truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/exact/exact.h"
#include "cases/exact/exact_test_scenes.h"
#include "harness/catalogue.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "reference/above_floor_test.h"
#include "reference/full_model.h"

namespace mb {
namespace {

struct PulsedSphere {
  Scene scene = sphere_scene();
  EvaluationPoints points = evaluation_points(scene, scene.bodies[0]);
  TruthSet truth;

  PulsedSphere() {
    const VectorXd t = VectorXd::LinSpaced(61, 0, scene.duration);
    const ExactSolution& solution = exact_solution("sphere-radial-pulse");
    truth.exact = solution.at(scene, points, t);
    truth.exact_bar = solution.error_bar;
  }
  double bar(const std::string& name, Index probe = -1) const {
    return error_bar(metric(name), truth, TruthKind::exact, {scene, 0, points, true, probe});
  }
  double largest() const {
    const MatrixXd& u = truth.exact->bodies[0].displacement;
    return u.reshaped(3, u.size() / 3).colwise().norm().maxCoeff();
  }
};

// A sphere of 0.3 m whose surface moves by micrometres: its pose is not known to 1e-9 m but to 1e-9 of that.
TEST(ErrorBar, AgainstAClosedFormIsInTheUnitOfTheMetric) {
  const PulsedSphere sphere;
  const double relative = sphere.truth.exact_bar, u = sphere.largest();
  ASSERT_GT(relative, 0);
  ASSERT_GT(u, 0);
  ASSERT_LT(u, 1e-3);
  for (const char* name : {"displacement-error", "strain-error"}) EXPECT_EQ(sphere.bar(name), relative) << name;
  EXPECT_DOUBLE_EQ(sphere.bar("pose-translation"), relative * u);
  const double gyration = 0.3 * std::sqrt(0.6);
  EXPECT_NEAR(sphere.bar("pose-rotation"), relative * u / gyration,
              1e-3 * relative * u / gyration);  // of some 300 points
  EXPECT_DOUBLE_EQ(sphere.bar("surface-deviation"), relative * u / 0.6);
}

TEST(ErrorBar, OfAProbeIsRelativeToWhatTheProbeSees) {
  const PulsedSphere sphere;
  const double relative = sphere.truth.exact_bar;
  for (const char* name : {"probe-error", "probe-magnitude", "probe-phase", "probe-combined"}) {
    EXPECT_GE(sphere.bar(name, 0), relative) << name;  // at the surface, which moves most but for what focuses inside
    EXPECT_LT(sphere.bar(name, 0), 2 * relative) << name;
    EXPECT_TRUE(std::isinf(sphere.bar(name, 1))) << name;  // the centre never moves
  }
  EXPECT_GT(sphere.bar("probe-von-mises", 0), relative);  // stress of the surface is less than that inside
}

TEST(ErrorBar, GrowsWithTheTruthInMetresAndNotWhereItIsRelative) {
  PulsedSphere sphere;
  const double relative = sphere.bar("displacement-error"), metres = sphere.bar("pose-translation"),
               radians = sphere.bar("pose-rotation"), probe = sphere.bar("probe-error", 0);
  sphere.truth.exact->bodies[0].displacement *= 10;
  EXPECT_EQ(sphere.bar("displacement-error"), relative);
  EXPECT_NEAR(sphere.bar("pose-translation"), 10 * metres, 1e-12 * metres);
  EXPECT_NEAR(sphere.bar("pose-rotation"), 10 * radians, 1e-12 * radians);
  EXPECT_NEAR(sphere.bar("probe-error", 0), probe, 1e-12 * probe);
}

// Two meshes, two tolerances that agree: what is left is the mass that both lack, and what a closed form knows better.
struct AgreeingTruths : PulsedSphere {
  AgreeingTruths() {
    truth.finer = truth.coarser = truth.same_mesh = truth.loose = *truth.exact;
    truth.exact.reset();
    truth.missing_volume = 0.01;
  }
  double of_finer(const std::string& name, Index probe = -1) const {
    return error_bar(metric(name), truth, TruthKind::finer, {scene, 0, points, true, probe});
  }
};

TEST(ErrorBar, HoldsWhatBothMeshesLackOfTheMass) {
  AgreeingTruths sphere;
  EXPECT_DOUBLE_EQ(sphere.of_finer("displacement-error"), 0.01);
  EXPECT_GE(sphere.of_finer("probe-error", 0), 0.01);
  const BodyTrajectory& body = sphere.truth.finer.bodies[0];
  EXPECT_LT(sphere.of_finer("truth-strain"), 0.01 * body.strain.cwiseAbs().maxCoeff() * 1.5);
  EXPECT_GT(sphere.of_finer("truth-strain"), 0);
  EXPECT_EQ(error_bar(metric("displacement-error"), sphere.truth, TruthKind::same_mesh,
                      {sphere.scene, 0, sphere.points, true, -1}),
            0);  // it lacks as much as the answer on its mesh
  sphere.truth.missing_volume = 0;
  EXPECT_EQ(sphere.of_finer("displacement-error"), 0);
}

double missing_volume_of_truths(const Resolution& finer, const Resolution& coarser) {
  auto scene = std::make_shared<Scene>(
      testing::above_floor(one_body(Sphere{0.05}, {1e6, 0.3, 1000, {}}, {2, {2}}), {0, 0, 0.051}, 2e-3));
  scene->samples_per_second = scene->frame_rate = 1e3;
  scene->truth.relative_tolerance = 1e-3;
  scene->truth.finer = finer;
  scene->truth.coarser = coarser;
  const ScratchFolder folder;
  const auto set = truths(
      scene, default_catalogue(), Store(folder.path()), [](const std::string&) {}, [] { return false; });
  const double lack = missing_volume(*scene, finer), other = missing_volume(*scene, coarser);
  EXPECT_GT(lack, 1e-6);
  EXPECT_LE(lack, other);
  return set ? set->missing_volume / lack : -1;
}

// What two meshes differ by is in the distance of their truths: cells of half the size lack a sixteenth, and the
// coarser ones show the rest. Where only those about a contact are halved, most of what is lacking is the same in both.
TEST(Truths, LackOfTheVolumeWhatBothMeshesLack) {
  EXPECT_EQ(missing_volume_of_truths({2, {2}}, {2, {2}}), 1);
  EXPECT_EQ(missing_volume_of_truths({2, {2}}, {1, {2}}), 0);
  const double graded = missing_volume_of_truths({2, {2}, 2}, {2, {2}, 1});
  EXPECT_GT(graded, 0.5);
  EXPECT_LT(graded, 1);
}

TEST(ErrorBar, IsNoLessThanTheDistanceToAClosedForm) {
  AgreeingTruths sphere;
  sphere.truth.exact = sphere.truth.finer;
  sphere.truth.exact->bodies[0].displacement *= 1.25;
  EXPECT_NEAR(sphere.of_finer("displacement-error"), 0.25 - sphere.truth.exact_bar, 1e-12);
  sphere.truth.missing_volume = 0.3;
  EXPECT_DOUBLE_EQ(sphere.of_finer("displacement-error"), 0.3);
}

TEST(ErrorBar, NeedsATruthOfTheKind) {
  const PulsedSphere sphere;
  TruthSet none;
  EXPECT_THROW(
      error_bar(metric("displacement-error"), none, TruthKind::exact, {sphere.scene, 0, sphere.points, true, -1}),
      std::logic_error);
}

}  // namespace
}  // namespace mb
