#include "reference/sundials/sundials.h"
#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/algebra/fitted_order_test.h"

#include <gtest/gtest.h>

#include "cases/scene/one_body.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/modal_form.h"
#include "mechanics/system/newmark.h"
#include "mechanics/verified_test.h"
#include "reference/full_model.h"

namespace mb {
namespace {

using testing::expect_verified;

const Material gelatine{2e4, 0.45, 1100};

Scene small_cylinder(const History& history, const Rayleigh& damping) {
  Scene scene = one_body(Cylinder{0.05, 0.2}, gelatine, {2, {1, 2}});
  scene.bodies[0].damping = damping;
  scene.loads.push_back(
      {"ends", history, {{"body", {"z-min", {}}, {0, 0, 400}}, {"body", {"z-max", {}}, {0, 0, -400}}}});
  return scene;
}

double relative(const SparseMatrix& A, const MatrixXd& x, const MatrixXd& y) {
  const MatrixXd e = x - y;
  return std::sqrt((e.transpose() * (A * e)).trace() / (y.transpose() * (A * y)).trace());
}

const VectorXd times = VectorXd::LinSpaced(88, 0, 0.29);

struct Errors {
  double M, K;  // [-] in the norms of M and K
};
// The reference against the closed form of all modes of a small mesh: same M and K, two independent time integrations.
Errors expect_agreement(const Scene& scene, double tolerance_M = 1e-7, double tolerance_K = 1e-7,
                        double load_tolerance = 1e-6) {
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const System& s = model->system();
  const States closed = exact(s, 0.29, load_tolerance)->run(times), stepped = sundials(s, 1e-10, 0.29)->run(times);
  EXPECT_EQ(stepped.status, Status::ok);
  const Errors errors{relative(s.M, stepped.u, closed.u), relative(s.K, stepped.u, closed.u)};
  EXPECT_LT(errors.M, tolerance_M);
  EXPECT_LT(errors.K, tolerance_K);
  return errors;
}
void expect_closed_form(const std::string& quantity, double tolerance, const std::string& why, double error) {
  expect_verified({.quantity = quantity,
                   .reference = "second route",
                   .source = "closed form of all modes of the same mesh",
                   .uncertainty = "rounding of a dense eigenproblem",
                   .tolerance = tolerance,
                   .why = why},
                  error);
}
TEST(SundialsVerification, PulseAgreesWithAllModes) {
  const Errors errors = expect_agreement(small_cylinder(Pulse{0.096881}, {1.5733, 0}));
  expect_closed_form("displacement of a damped cylinder under a pulse, over 88 times, mass norm", 1e-7,
                     "A thousand times the tolerance of a step, 1e-10, whose errors add up.", errors.M);
}
TEST(SundialsVerification, RayleighDampedPulseAgreesWithAllModes) {
  expect_agreement(small_cylinder(Pulse{0.05}, {1.5733, 2e-4}));
}
TEST(SundialsVerification, HarmonicAgreesWithAllModes) {
  expect_agreement(small_cylinder(Harmonic{60.0}, {1.5733, 0}));
}
TEST(SundialsVerification, TableWithKinksAgreesWithAllModes) {
  expect_agreement(small_cylinder(Table{{0, 0.05, 0.1, 0.2}, {0, 1, -0.5, 0}}, {0, 1e-4}));
}

// A jump excites every frequency of the mesh, which the K norm weighs: seen 1.3e-7 to 6e-7 there.
TEST(SundialsVerification, AStepInsideTheRunAgreesWithAllModes) {
  const Errors errors = expect_agreement(small_cylinder(Step{1, 0.1}, {1.5733, 0}), 1e-7, 2e-6);
  expect_closed_form(
      "displacement of a damped cylinder under a step of load inside the run, over 88 times, energy norm", 2e-6,
      "A jump excites every frequency of the mesh, which the energy weighs: 6e-7 was seen.", errors.K);
}
TEST(SundialsVerification, ALoadOutOfBalanceAcceleratesTheWholeBody) {
  Scene scene = small_cylinder(Step{1, 0.1}, {1.5733, 0});
  scene.loads[0].tractions.pop_back();
  expect_agreement(scene, 1e-7, 2e-6);
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const System& s = model->system();
  const States states = sundials(s, 1e-8, 0.29)->run(times);
  const double t = times[times.size() - 1] - 0.1;  // rigid part: R^T M u = R^T F t^2 / 2, undamped
  const VectorXd rigid = s.R.transpose() * (s.M * states.u.rightCols(1)),
                 expected = 0.5 * t * t * s.R.transpose() * s.F;
  EXPECT_LT((rigid - expected).norm(), 1e-6 * expected.norm());
}
TEST(SundialsVerification, SupportedBodiesAgreeWithAllModes) {
  Scene scene = small_cylinder(Step{1, 0.1}, {1.5733, 0});
  scene.bodies[0].supports = {{Support::Kind::mean, {"z-min", Disc{{0, 0, -0.1}, 0.03}}, {}},
                              {Support::Kind::sliding, {"z-max", {}}, {}}};
  expect_agreement(scene, 1e-7, 2e-6);
}

// Ratios of their own for the first elastic modes, the first one's 0: its Rayleigh damping is taken back.
TEST(SundialsVerification, ModalDampingAgreesWithAllModesAndNewmark) {
  const Scene scene = small_cylinder(Pulse{0.05}, {});
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  for (const Rayleigh& rayleigh : {Rayleigh{}, Rayleigh{1.5733, 1e-5}}) {
    System s = model->system();
    const ModalForm form = modal_form(s);
    const VectorXd lambda = form.lambda.segment(6, 9), zeta = VectorXd::LinSpaced(9, 0, 0.2);
    s.damping = rayleigh;
    s.modal_damping.W = s.M * form.Phi.middleCols(6, 9);
    s.modal_damping.d = 2 * zeta.array() * lambda.array().sqrt() - rayleigh.alpha - rayleigh.beta * lambda.array();
    const States closed = exact(s, 0.29)->run(times), stepped = sundials(s, 1e-10, 0.29)->run(times);
    ASSERT_EQ(stepped.status, Status::ok);
    EXPECT_LT(relative(s.M, stepped.u, closed.u), 1e-7);
    EXPECT_LT(relative(s.K, stepped.u, closed.u), 1e-6);
    System without = s;
    without.modal_damping = {};
    EXPECT_GT(relative(s.M, stepped.u, exact(without, 0.29)->run(times).u), 1e-3);  // it does something
    std::vector<double> errors;
    for (const double h : {5e-4, 2.5e-4}) errors.push_back(relative(s.M, newmark(s, h)->run(times).u, stepped.u));
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.15);
  }
}

TEST(SundialsVerification, ReleaseFromOneModeIsACosine) {
  Scene scene = small_cylinder(Pulse{0.1}, {});
  scene.loads.clear();
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  System s = model->system();
  const EigenPairs modes = generalized_eigen(MatrixXd(s.K), MatrixXd(s.M)).value();
  const Index i = 9;  // the first axial mode: six rigid, two bending, one torsion precede it
  const double omega = std::sqrt(modes.values[i]);
  s.u0 = 1e-3 * modes.vectors.col(i);
  MatrixXd expected(s.u0.size(), times.size());
  for (Index k = 0; k < times.size(); ++k) expected.col(k) = std::cos(omega * times[k]) * s.u0;
  const States states = sundials(s, 1e-10, 0.29)->run(times);
  // Three periods in some 140 steps, each within 1e-10 of the amplitude, and the interpolation between them: seen 8e-8.
  EXPECT_LT(relative(s.M, states.u, expected), 3e-7);
}

// What samples of a formula miss, its bounds do not: 1e-5 of the run, at a hundred times the rest of the load.
TEST(SundialsVerification, AShortWindowOfAFormulaAgreesWithAllModes) {
  const Errors errors = expect_agreement(
      small_cylinder(Expression{"0.01*sin(10*t)^2 + (t > 0.15093 ? (t < 0.150933 ? 100 : 0) : 0)"}, {1.5733, 0}), 1e-6,
      1e-5, 1e-7);
  expect_closed_form("displacement under a formula that is 1 for 3e-6 s and 1e-4 elsewhere, over 88 times, mass norm",
                     1e-6, "Ten times the load error that its lines are resampled to.", errors.M);
}

// The peak of such a load moves nothing near as far as it would if it lasted: tolerances that rest on it are met by
// whatever comes out.
TEST(SundialsVerification, APulseFarShorterThanAllPeriodsAgreesWithAllModes) {
  double off = 0;
  for (const double length : {1e-6, 1e-8, 1e-10}) {
    const Scene scene = small_cylinder(Pulse{length, 1, 0.1}, {1.5733, 0});
    const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
    const System& s = model->system();
    const States closed = exact(s, 0.29)->run(times);
    const States loose = sundials(s, 1e-6, 0.29)->run(times), tight = sundials(s, 1e-8, 0.29)->run(times);
    EXPECT_LT(relative(s.M, loose.u, closed.u), 1e-3) << length;
    off = worse(off, relative(s.M, tight.u, closed.u));
    EXPECT_GT(tight.work.steps, loose.work.steps) << "a tolerance that asks for nothing tells of no error";
  }
  EXPECT_LT(off, 1e-5);
  expect_closed_form("displacement under pulses of 1e-6, 1e-8 and 1e-10 s, over 88 times, mass norm", 1e-5,
                     "A thousand times the tolerance of a step, 1e-8, whose errors add up.", off);
}

TEST(Sundials, ErrorFallsWithTheTolerance) {
  const Scene scene = small_cylinder(Pulse{0.096881}, {1.5733, 0});
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const System& s = model->system();
  const States closed = exact(s, 0.29)->run(times);
  double previous = 1;
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    const States stepped = sundials(s, tolerance, 0.29)->run(times);
    const double error = relative(s.M, stepped.u, closed.u);
    EXPECT_LT(error, 0.1 * previous) << tolerance;
    EXPECT_LT(stepped.work.factorisations, 22)  // two of the preparation
        << "of " << stepped.work.steps << " steps: the factor is meant to be reused";
    previous = error;
  }
}

// ARKODE's default table of order 5, the implicit half of ARK5(4)8L[2]SA (Kennedy & Carpenter 2003, Appl. Numer. Math.
// 44). Least squares through log(error) over log(mean step): seen 4.79 and 4.80, of steps that are not all of one size.
// 0.5 tells 5 from the embedded 4.
TEST(SundialsVerification, OrderFiveInTheMeanStep) {
  double off = 0;
  for (const double alpha : {0.0, 1.5733}) {
    const Scene scene = small_cylinder(Pulse{0.096881}, {alpha, 0});
    const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
    const System& s = model->system();
    const States closed = exact(s, 0.29)->run(times);
    std::vector<double> step, error;
    for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11}) {
      const States stepped = sundials(s, tolerance, 0.29)->run(times);
      step.push_back(0.29 / static_cast<double>(stepped.work.steps));
      error.push_back(relative(s.M, stepped.u, closed.u));
    }
    const double order = testing::fitted_order(step, error);
    EXPECT_NEAR(order, 5, 0.5) << "alpha " << alpha;
    off = worse(off, std::abs(order - 5));
  }
  expect_verified({.quantity = "distance of the order of adaptive Runge-Kutta in its mean step from 5, absolute: "
                               "displacement of a cylinder under a pulse, mass norm",
                   .reference = "published",
                   .source = "ARK5(4)8L[2]SA, implicit half: Kennedy and Carpenter 2003, Appl. Numer. Math. 44",
                   .uncertainty = "none; errors are against the closed form of all modes",
                   .tolerance = 0.5,
                   .why = "Tells 5 from the embedded 4; steps are not all of one size: 4.8 was seen."},
                  off);
}

TEST(Sundials, RefusesBadArguments) {
  const Scene scene = small_cylinder(Pulse{0.1}, {});
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  EXPECT_THROW(sundials(model->system(), 0, 1), std::invalid_argument);
  EXPECT_THROW(sundials(model->system(), 1e-6, 0), std::invalid_argument);
  System broken = model->system();
  broken.u0[0] = std::nan("");
  EXPECT_THROW(sundials(broken, 1e-6, 1), std::runtime_error);
}

TEST(NewmarkVerification, SecondOrderAgainstAllModes) {
  const Scene scene = small_cylinder(Pulse{0.096881}, {1.5733, 1e-4});
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const System& s = model->system();
  const VectorXd t = VectorXd::LinSpaced(30, 0, 0.29);
  const States closed = exact(s, 0.29)->run(t);
  std::vector<double> errors;
  for (const double h : {1e-3, 5e-4, 2.5e-4}) errors.push_back(relative(s.M, newmark(s, h)->run(t).u, closed.u));
  Eigen::Vector2d off;
  for (Index i = 0; i < 2; ++i)
    off[i] = std::log2(errors[static_cast<size_t>(i)] / errors[static_cast<size_t>(i) + 1]) - 2;
  expect_verified(
      {.quantity = "distance of the order of average acceleration from 2, absolute: displacement of a damped "
                   "cylinder under a pulse, mass norm",
       .reference = "property",
       .source = "second order: Newmark 1959, J. Eng. Mech. Div. ASCE 85(3)",
       .uncertainty = "none; errors are against the closed form of all modes",
       .tolerance = 0.1,
       .why = "At the coarsest of three steps, 1 ms, the error's next term bends a fit over one halving."},
      off.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

TEST(Newmark, ConservesEnergyOfAFreeUndampedBody) {
  Scene scene = small_cylinder(Pulse{0.1}, {});
  scene.loads.clear();
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  System s = model->system();
  s.v0 = VectorXd::LinSpaced(s.u0.size(), -1, 1);
  const VectorXd t = VectorXd::LinSpaced(1001, 0, 1);  // the steps' own times: interpolation is not conservative
  const States states = newmark(s, 1e-3)->run(t);
  const double initial = kinetic_energy(s, s.v0);
  for (Index k = 0; k < t.size(); k += 50)
    EXPECT_NEAR(kinetic_energy(s, states.v.col(k)) + strain_energy(s, states.u.col(k)), initial, 1e-9 * initial);
}

TEST(Newmark, RefusesAStepThatIsNotPositive) {
  const Scene scene = small_cylinder(Pulse{0.1}, {});
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  for (const double h : {0.0, -1.0, std::nan("")}) EXPECT_THROW(newmark(model->system(), h), std::invalid_argument);
}

}  // namespace
}  // namespace mb
