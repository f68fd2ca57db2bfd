// Scenes told in other systems of units: lengths by L, masses by M, times by T. What has a dimension follows, what has
// none stays: no tolerance, bound or default of unit size hides anywhere between a scene and its answer.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "cases/contract/physical_shift.h"
#include "harness/analysis/modal_body.h"
#include "harness/study/truth.h"
#include "harness/units_test.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/verified_test.h"
#include "modal/bases/eigenmodes.h"
#include "modal/bases/mode_differences_test.h"

namespace mb {
namespace {

using testing::expect_verified;
using testing::si;
using testing::told;
using testing::Units;

double relative(const MatrixXd& a, const MatrixXd& b) { return (a - b).norm() / b.norm(); }

// [-] largest |A_ij - B_ij| / sqrt(B_ii B_jj): each entry by the size of its own unknowns, be they soft or stiff.
double largest_of_entries(const SparseMatrix& A, const SparseMatrix& B) {
  const SparseMatrix D = A - B;
  const VectorXd size = VectorXd(B.diagonal()).cwiseSqrt();
  double largest = 0;
  for (Index j = 0; j < D.outerSize(); ++j)
    for (SparseMatrix::InnerIterator d(D, j); d; ++d) {
      const double off = std::abs(d.value()) / (size[d.row()] * size[j]);
      if (!(off <= largest)) largest = off;  // NaN, too
    }
  return largest;
}

// A body in metres, kilograms and seconds, and in other units.
struct Twice {
  Twice(const std::string& file, const Units& u)
      : own(told(file, si)),
        other(told(file, u)),
        own_model(make_model(own, own_meshes(*own))),
        other_model(make_model(other, own_meshes(*other))) {}
  const System& own_system() const { return own_model.bodies[0].full->system(); }
  const System& other_system() const { return other_model.bodies[0].full->system(); }

  std::shared_ptr<const Scene> own, other;
  Model own_model, other_model;
};

Trajectory answer(const Model& model, const std::string& method, const std::string& integrator,
                  const Settings& settings) {
  const Catalogue catalogue = default_catalogue();
  return catalogue.method(method)
      .prepare(model, settings, catalogue.integrator(integrator))
      ->simulate({sample_times(*model.scene), true});
}

// [-] of displacements over L and of strains, relative, the larger.
double difference(const Twice& twice, const Units& u, const std::string& method, const std::string& integrator,
                  Settings settings) {
  const Trajectory own = answer(twice.own_model, method, integrator, settings);
  settings.time_step *= u.T;
  const Trajectory other = answer(twice.other_model, method, integrator, settings);
  EXPECT_EQ(own.status, Status::ok) << integrator;
  EXPECT_EQ(other.status, Status::ok) << integrator;
  const BodyTrajectory &a = own.bodies[0], &b = other.bodies[0];
  return VectorXd{{relative(b.displacement / u.L, a.displacement), relative(b.strain, a.strain)}}
      .maxCoeff<Eigen::PropagateNaN>();
}

class UnitsVerification : public ::testing::TestWithParam<Units> {
 protected:
  void expect_same(
      const std::string& what, double worst, double tolerance, const std::string& why,
      const char* uncertainty = "rounding of either, times the condition that the tolerance counts") const {
    expect_verified({.quantity = fmt::format("{}, told in {}, the worst", what, GetParam().name),
                     .reference = "property",
                     .source = "the same bodies told in m, kg, s: nothing depends on units",
                     .uncertainty = uncertainty,
                     .tolerance = tolerance,
                     .why = why},
                    worst);
  }
};
INSTANTIATE_TEST_SUITE_P(Systems, UnitsVerification,
                         ::testing::Values(testing::mm_tonne, testing::cgs, testing::mm_mg_ms),
                         [](const auto& each) { return std::to_string(each.index); });

TEST_P(UnitsVerification, MatricesFollow) {
  const Units u = GetParam();
  double worst = 0;
  for (const char* file : {"cylinder-combined.toml", "hard/dashpot.toml", "hard/microsecond-beam.toml",
                           "hard/geological-tower.toml", "hard/stiffness-contrast.toml"}) {
    const Twice twice(file, u);
    const System &s = twice.own_system(), &t = twice.other_system();
    const double of_K = largest_of_entries(t.K * (u.T * u.T / u.M), s.K), of_M = largest_of_entries(t.M / u.M, s.M);
    EXPECT_LT(of_K, 1e-10) << file;
    EXPECT_LT(of_M, 1e-10) << file;
    worst = VectorXd{{worst, of_K, of_M}}.maxCoeff<Eigen::PropagateNaN>();
  }
  expect_same(
      "every entry of stiffness and mass of five bodies, of microseconds and of hours among them, over "
      "sqrt(K_ii K_jj) and sqrt(M_ii M_jj)",
      worst, 1e-10, "Sums of some hundred products, each rounded; the rest is room.");
}

TEST_P(UnitsVerification, ModesFollow) {
  const Units u = GetParam();
  testing::ModeDifferences uniform;
  double contrast = 0;
  for (const char* file : {"cylinder-combined.toml", "hard/dashpot.toml", "hard/stiffness-contrast.toml"}) {
    const Twice twice(file, u);
    const Modes one = lowest_modes(twice.own_system(), 16, physical_shift(twice.own->bodies[0]));
    const Modes two = lowest_modes(twice.other_system(), 16, physical_shift(twice.other->bodies[0]));
    ASSERT_EQ(two.n_rigid, one.n_rigid) << file;
    const auto found = testing::mode_differences(twice.own_system().M, one.n_rigid, one.omega.cwiseAbs2(), one.Phi,
                                                 (two.omega * u.T).cwiseAbs2(), two.Phi * std::sqrt(u.M));
    EXPECT_GE(found.n, 12) << file;
    if (twice.own->bodies[0].material.inclusions.empty()) {
      uniform.frequency = worse(uniform.frequency, found.frequency);
      uniform.subspace = worse(uniform.subspace, found.subspace);
    } else {
      contrast = worse(found.frequency, found.subspace);
    }
  }
  expect_same("twelve and more frequencies of two bodies, each", uniform.frequency, 1e-10,
              "Rounding times the spread of the spectrum, 1e6 at most.");
  expect_same("subspaces of the modes of two bodies, clusters apart by 1e-3 and more, sine of the angle times the gap",
              uniform.subspace, 1e-10, "The residual at which block Lanczos stops.");
  expect_same(
      "frequencies, each, and subspaces of the modes of a body of a stiffness contrast of 1e6", contrast, 1e-7,
      "Rounding of the stiff entries is work against the soft modes, known to eps lambda_max/lambda_1 = 3e-6 at "
      "worst; a thirtieth of that, since roundings do not conspire.");
}

// Of bodies whose spectrum spreads so far that rounding of K moves the lowest modes: not to 1e-10, but as far as that
// accounts for.
TEST_P(UnitsVerification, FrequenciesOfIllConditionedBodiesFollowAsRoundingLeavesThem) {
  const Units u = GetParam();
  double worst = 0, least_rounding = 1;
  for (const char* file : {"hard/slender-rod.toml", "hard/stiffness-contrast.toml", "hard/million-steps.toml",
                           "hard/microsecond-beam.toml", "hard/geological-tower.toml"}) {
    const Twice twice(file, u);
    const Modes one = lowest_modes(twice.own_system(), 16, physical_shift(twice.own->bodies[0]));
    const Modes two = lowest_modes(twice.other_system(), 16, physical_shift(twice.other->bodies[0]));
    ASSERT_EQ(two.n_rigid, one.n_rigid) << file;
    ASSERT_GE(std::min(one.size(), two.size()), one.n_rigid + 12) << file;
    for (Index i = one.n_rigid; i < one.n_rigid + 12; ++i) {
      const double rounding = rounding_of_frequency(one, one.omega[i]);
      worst = worse(worst, std::abs(two.omega[i] * u.T / one.omega[i] - 1) / rounding);
      least_rounding = std::min(least_rounding, rounding);
    }
  }
  EXPECT_GT(least_rounding, 1e-13) << "not ill-conditioned: of the size of a sum's rounding";
  expect_same(
      "twelve frequencies of a rod of aspect 200, of a body of a stiffness contrast of 1e6, of a tuning fork's prong, "
      "of a beam of micrometres and of a tower of kilometres, over eps lambda_max/(2 lambda) of each",
      worst, 1,
      "Entries of K are sums whose terms are rounded by eps of themselves, which moves lambda by the order of "
      "eps lambda_max; a fifth of it was seen.");
}

TEST_P(UnitsVerification, ClosedFormsFollow) {
  double worst = 0;
  for (const char* file : {"cylinder-combined.toml", "hard/dashpot.toml"}) {
    const Twice twice(file, GetParam());
    for (const char* method : {"eigenmodes", "static-correction"}) {
      const double off = difference(twice, GetParam(), method, "exact", {.modes = 12});
      EXPECT_LT(off, 1e-10) << file << method;
      worst = VectorXd{{worst, off}}.maxCoeff<Eigen::PropagateNaN>();
    }
  }
  expect_same("displacements and strains of two bodies over time, closed form of twelve modes, each as a whole", worst,
              1e-10, "Rounding times a condition of at most 1e6.");
  const Twice contrast("hard/stiffness-contrast.toml", GetParam());
  expect_same(
      "displacements and strains over time of a body of a stiffness contrast of 1e6, closed form of twelve modes",
      difference(contrast, GetParam(), "eigenmodes", "exact", {.modes = 12}), 1e-6,
      "Its modes and frequencies are the same to 1e-7, and phases grow by a radian a radian.");
}

TEST_P(UnitsVerification, FixedStepsFollow) {
  double worst = 0;
  const auto compare = [&](const Twice& twice, const char* method, const char* integrator, const Settings& settings) {
    const double off = difference(twice, GetParam(), method, integrator, settings);
    EXPECT_LT(off, 1e-10) << method << integrator << settings.time_step;
    worst = VectorXd{{worst, off}}.maxCoeff<Eigen::PropagateNaN>();
  };
  const Twice cylinder("cylinder-combined.toml", GetParam()), bar("hard/dashpot.toml", GetParam());
  for (const Twice* twice : {&cylinder, &bar}) {
    for (const char* integrator : {"central-difference", "explicit-euler", "symplectic-euler"})
      compare(*twice, "eigenmodes", integrator, {.modes = 12, .time_step = 2e-4});
    // Its velocities are differences of displacements: each rounds by eps u / h.
    compare(*twice, "eigenmodes", "newmark", {.modes = 12, .time_step = 1e-3});
  }
  compare(cylinder, "full-order", "newmark", {.time_step = 4e-3});
  compare(bar, "full-order", "newmark", {.time_step = 1e-3});
  for (const char* integrator : {"central-difference", "symplectic-euler"})  // with the mass lumped
    compare(bar, "full-order", integrator, {.time_step = 5e-5});
  expect_same(
      "displacements and strains of two bodies over time, by four schemes of fixed steps in twelve modes and by "
      "three in full order, each as a whole",
      worst, 1e-10, "Rounding times a condition of at most 1e6.");
}

// Steps are chosen by estimates of the error: either answer is within the error of one, both within twice that.
TEST_P(UnitsVerification, AdaptiveStepsFollowWithinTheirErrorBars) {
  const Units u = GetParam();
  double worst_u = 0, worst_eps = 0;
  for (const char* file : {"hard/dashpot.toml", "hard/beyond-linear.toml"}) {  // the second one of finite strain
    const Twice twice(file, u);
    const Trajectory one = answer(twice.own_model, "full-order", "sundials", {.relative_tolerance = 1e-4});
    const Trajectory two = answer(twice.other_model, "full-order", "sundials", {.relative_tolerance = 1e-4});
    const Trajectory truth = answer(twice.own_model, "full-order", "sundials", {.relative_tolerance = 1e-6});
    const BodyTrajectory &a = one.bodies[0], &b = two.bodies[0], &exact = truth.bodies[0];
    const double bar_u = 2 * relative(a.displacement, exact.displacement);
    const double bar_eps = 2 * relative(a.strain, exact.strain);
    worst_u = worse(worst_u, relative(b.displacement / u.L, a.displacement) / bar_u);
    worst_eps = worse(worst_eps, relative(b.strain, a.strain) / bar_eps);
  }
  expect_same(
      "displacements of two bodies, one of finite strain, in full order by adaptive steps at rtol 1e-4 over time, over "
      "their error bars",
      worst_u, 1, "Either answer is within the error of one against rtol 1e-6, both within twice that.",
      "the error bar itself");
  expect_same("strains likewise", worst_eps, 1, "Likewise.", "the error bar itself");
}

// The layer is pressed by 1e-6 of the block: what places round by comes back a million times as large in its force.
TEST_P(UnitsVerification, ContactFollows) {
  const Units u = GetParam();
  const Twice twice("hard/resting.toml", u);
  struct Followed {
    const char *method, *integrator;
    int r;
    double h, of_force, of_place;  // [s], [-], [-]
    const char* why;
  };
  for (const auto& [method, integrator, r, h, of_force, of_place, why] :
       {Followed{"eigenmodes", "exact", 0, 1e-4, 1e-9, 1e-12,
                 "Places round by 1e-15 of the block, and the layer is pressed by 1e-6 of it."},
        {"static-correction", "exact", 16, 1e-4, 1e-5, 1e-7,
         "Modes are known to 1e-10, whose pairs a stiff layer that shakes turns into each other: places follow "
         "a thousandfold, its force ten thousand times, a digit of room either."},
        {"full-order", "newmark", -1, 1e-3, 1e-10, 1e-10, "Rounding times a condition of at most 1e6."},
        {"full-order", "central-difference", -1, 1e-4, 1e-10, 1e-10, "Likewise."}}) {
    const Trajectory one = answer(twice.own_model, method, integrator, {.modes = r, .time_step = h});
    const Trajectory two = answer(twice.other_model, method, integrator, {.modes = r, .time_step = h * u.T});
    const double force = u.M * u.L / (u.T * u.T);
    const std::string by = r < 0 ? fmt::format("{}, {}", method, integrator) : fmt::format("{} r = {}", method, r);
    const std::string what = " of a block at rest on a stiff layer over time, " + by;
    expect_same("contact force" + what, relative(two.bodies[0].contact.force / force, one.bodies[0].contact.force),
                of_force, why);
    expect_same("displacement" + what, relative(two.bodies[0].displacement / u.L, one.bodies[0].displacement), of_place,
                why);
  }
}

}  // namespace
}  // namespace mb
