// NAFEMS 5T and 5H: a deep simply supported beam, 2 x 2 x 10 m, E 200 GPa, nu 0.3, rho 8000 kg/m^3, under 1e6 N/m all
// along, suddenly applied (5T) or harmonic about the first resonance (5H), with 2 % of critical damping there
// (Rayleigh). NAFEMS R0016, Selected Benchmarks for Forced Vibration. Published, from beam elements that shear, at
// mid-span:
//
//   static 0.538 mm       5T: peak 1.043 mm at 11.7 ms       5H: 13.45 mm at 42.65 Hz
//
// Here a solid: its end sections cannot move across the beam but may along it (diaphragms), the mean axial displacement
// of one of them is zero, and the load is a traction of 5e5 Pa on one side. Compared is the centre of the mid-section.
//
// Seen: static 0.5299 mm (-1.5 %), 42.70 Hz (+0.1 %), peak 1.0304 mm (-1.2 %) at 11.67 ms. The static difference is the
// beam theory's: plane stress (Timoshenko & Goodier 1970, Theory of Elasticity, art. 22) has
//
//   5 q l^4/(24 E I) (1 + 12/5 (c/l)^2 (4/5 + nu/2)) = 0.5328 mm,     half length l, half depth c,
//
// 1 % less; the diaphragms, which keep the end sections from contracting, take another 0.5 %.
#include <gtest/gtest.h>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/frequency_response.h"
#include "mechanics/system/newmark.h"
#include "mechanics/verified_test.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

using testing::expect_verified;
using testing::face;
using testing::support;

constexpr double alpha = 5.36, beta = 7.46e-5;  // [1/s], [s]

Scene deep_beam(const Resolution& resolution) {
  Scene scene = one_body(Box{{2, 2, 10}}, {200e9, 0.3, 8000}, resolution);
  scene.bodies[0].damping = {alpha, beta};
  scene.bodies[0].supports = {support(Support::Kind::diaphragm, face("z-min")),
                              support(Support::Kind::diaphragm, face("z-max")),
                              support(Support::Kind::mean, face("z-min"))};
  testing::load(scene, "y-max", {0, -5e5, 0});
  return scene;
}

struct Beam {
  explicit Beam(const Resolution& resolution = {3, {1, 1, 4}}) : scene(deep_beam(resolution)) {}
  Scene scene;
  std::shared_ptr<const FullModel> model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const System& s = model->system();
  VectorXd centre = -MatrixXd(model->displacement_at(Vector3d::Zero())).row(1);  // deflection at mid-span
  double deflection() const { return centre.dot(testing::static_solution(scene, s)); }
};

void expect_published(const std::string& quantity, const std::string& test, double published,
                      const std::string& uncertainty, double tolerance, const std::string& why, double got) {
  expect_verified({.quantity = "deep simply supported beam: " + quantity,
                   .reference = "published",
                   .source = "NAFEMS R0016, Selected Benchmarks for Forced Vibration, 1989, test " + test,
                   .uncertainty = uncertainty,
                   .tolerance = tolerance,
                   .why = why},
                  got / published - 1);
}

TEST(DeepBeamVerification, StaticDeflection) {
  const double deflection = Beam().deflection();
  expect_published("static deflection at mid-span", "5T", 0.538e-3,
                   "1e-3, the published digits; of the beam theory behind them about 1e-2", 0.02,
                   "Transverse stress, which beams leave out, takes 1 %, and the diaphragms another 0.5 %.",
                   deflection);
  expect_verified({.quantity = "deep simply supported beam: static deflection at mid-span",
                   .reference = "exact solution",
                   .source = "plane stress, Timoshenko and Goodier 1970, Theory of Elasticity, art. 22",
                   .uncertainty = "1e-4, the digits here; that a square section is in plane stress was not estimated",
                   .tolerance = 0.01,
                   .why = "The diaphragms keep the end sections from contracting, which takes 0.5 %."},
                  deflection / 0.5328e-3 - 1);
  // The mesh is not to blame: quartics differ by 1e-5, quadratics by 2 %.
  EXPECT_NEAR(deflection, Beam({4, {1, 1, 4}}).deflection(), 1e-4 * deflection);
  EXPECT_GT(std::abs(deflection - Beam({2, {1, 1, 4}}).deflection()), 1e-3 * deflection);
}

TEST(DeepBeamVerification, FirstFrequency) {
  const Beam beam;
  ASSERT_EQ(beam.s.R.cols(), 0);
  const VectorXd lambda = generalized_eigenvalues(MatrixXd(beam.s.K), MatrixXd(beam.s.M)).value();
  const double omega = std::sqrt(lambda[0]);
  // Beams that shear leave 0.1 %: a mode bears no surface load, hence none of the transverse stress that makes the
  // static deflection 1 % smaller.
  expect_published("first frequency", "5H, resonance", 42.65,
                   "5e-4: damping of 2 % lowers a peak by 4e-4, half a digit is 1e-4", 0.003,
                   "Beams that shear leave 0.1 %: modes bear no surface load and hence little transverse stress.",
                   omega / (2 * pi));
  EXPECT_NEAR(lambda[1] / lambda[0], 1, 1e-9);  // a square section bends both ways alike
  EXPECT_NEAR(alpha / (2 * omega) + beta * omega / 2, 0.02, 1e-4);
}

TEST(DeepBeamVerification, StepLoadPeaksWhereAndAsHighAsPublished) {
  const Beam beam;
  const double h = 1e-4;  // 240 a period: halving it moves the peak by 3e-5
  const VectorXd t = VectorXd::LinSpaced(201, 0, 200 * h);
  const VectorXd deflection = newmark(beam.s, h)->run(t).u.transpose() * beam.centre;
  Index peak = 0;
  expect_published("peak of the deflection under a sudden load", "5T", 1.043e-3,
                   "5e-4, the published digits; of the beam theory behind them about 1e-2", 0.02,
                   "As the static deflection, 1.5 %; halving the step moves the peak by 3e-5.",
                   deflection.maxCoeff(&peak));
  expect_published("time of the peak under a sudden load", "5T", 11.7e-3, "4e-3, half a published digit",
                   1.5 * h / 11.7e-3,
                   "One and a half steps of 0.1 ms: half a published digit, half a step, and as much again.", t[peak]);
  // A single mode would overshoot by 1 + exp(-pi zeta/sqrt(1 - zeta^2)) = 1.939 of the static deflection.
  EXPECT_NEAR(deflection[peak] / beam.deflection(), 1.939, 0.01 * 1.939);
}

TEST(DeepBeamVerification, HarmonicLoadResonatesWhereAndAsHighAsPublished) {
  const Beam beam;
  const VectorXd frequencies = VectorXd::LinSpaced(11, 42.2, 43.2);
  const Eigen::MatrixXcd u = frequency_response(beam.s, 0, 2 * pi * frequencies);
  const VectorXd amplitude = (beam.centre.transpose() * u).cwiseAbs().transpose();
  Index highest = 0;
  const double peak = amplitude.maxCoeff(&highest);
  expect_published("amplitude at resonance under a harmonic load", "5H", 13.45e-3,
                   "4e-4, the published digits; of the beam theory behind them about 1e-2", 0.02,
                   "As the static deflection, 1.5 %; frequencies 0.1 Hz apart miss the peak by 2e-3 at most.", peak);
  EXPECT_NEAR(frequencies[highest], 42.65, 0.003 * 42.65 + 0.05);  // as the first frequency, and half the spacing
}

}  // namespace
}  // namespace mb
