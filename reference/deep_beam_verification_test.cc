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

#include "mechanics/system/frequency_response.h"
#include "mechanics/system/newmark.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

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

TEST(DeepBeamVerification, StaticDeflection) {
  const double deflection = Beam().deflection();
  EXPECT_NEAR(deflection, 0.538e-3, 0.02 * 0.538e-3);
  EXPECT_NEAR(deflection, 0.5328e-3, 0.01 * 0.5328e-3);
  // The mesh is not to blame: quartics differ by 1e-5, quadratics by 2 %.
  EXPECT_NEAR(deflection, Beam({4, {1, 1, 4}}).deflection(), 1e-4 * deflection);
  EXPECT_GT(std::abs(deflection - Beam({2, {1, 1, 4}}).deflection()), 1e-3 * deflection);
}

TEST(DeepBeamVerification, FirstFrequency) {
  const Beam beam;
  ASSERT_EQ(beam.s.R.cols(), 0);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(MatrixXd(beam.s.K), MatrixXd(beam.s.M),
                                                                 Eigen::EigenvaluesOnly);
  const double omega = std::sqrt(modes.eigenvalues()[0]);
  // Beams that shear leave 0.1 %: a mode bears no surface load, hence none of the transverse stress that makes the
  // static deflection 1 % smaller.
  EXPECT_NEAR(omega / (2 * pi), 42.65, 0.003 * 42.65);
  EXPECT_NEAR(modes.eigenvalues()[1] / modes.eigenvalues()[0], 1, 1e-9);  // a square section bends both ways alike
  EXPECT_NEAR(alpha / (2 * omega) + beta * omega / 2, 0.02, 1e-4);
}

TEST(DeepBeamVerification, StepLoadPeaksWhereAndAsHighAsPublished) {
  const Beam beam;
  const double h = 1e-4;  // 240 a period: halving it moves the peak by 3e-5
  const VectorXd t = VectorXd::LinSpaced(201, 0, 200 * h);
  const VectorXd deflection = newmark(beam.s, h)->run(t).u.transpose() * beam.centre;
  Index peak = 0;
  EXPECT_NEAR(deflection.maxCoeff(&peak), 1.043e-3, 0.02 * 1.043e-3);
  EXPECT_NEAR(t[peak], 11.7e-3, 1.5 * h);  // the published digit and the step
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
  EXPECT_NEAR(peak, 13.45e-3, 0.02 * 13.45e-3);
  EXPECT_NEAR(frequencies[highest], 42.65, 0.003 * 42.65 + 0.05);  // as the first frequency, and half the spacing
}

}  // namespace
}  // namespace mb
