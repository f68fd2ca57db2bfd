#include "harness/analysis/step_limit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "cases/scene/read_toml.h"
#include "harness/analysis/context_test.h"
#include "harness/catalogue.h"
#include "harness/study/truth.h"
#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/system/oscillators_test.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using test::lumped_box;
using test::oscillators;

VectorXd ratios(const VectorXd& omega, const Rayleigh& damping) {
  return damping.alpha / (2 * omega.array()) + damping.beta * omega.array() / 2;
}
const VectorXd omega{{10, 35, 200}};  // [rad/s]

TEST(StepLimit, IsThatOfTheoryMadeOutOfAllModes) {
  for (const Rayleigh damping : {Rayleigh{0, 0}, Rayleigh{3, 0}, Rayleigh{0, 1e-4}, Rayleigh{3, 1e-4}})
    for (const Scheme& scheme : explicit_schemes()) {
      const VectorXd zeta = ratios(omega, damping);
      const double formula = formula_limit(scheme, omega, zeta);
      EXPECT_NEAR(measured_limit(scheme, omega, zeta).dt, formula, 1e-3 * formula) << scheme.name;
    }
}

TEST(StepLimit, OfExplicitEulerNeedNotComeFromTheHighestMode) {
  const VectorXd zeta{{1e-4, 0.05, 0.05}};
  const Scheme& euler = scheme("explicit-euler");
  EXPECT_EQ(measured_limit(euler, omega, zeta).deciding, 0);
  EXPECT_NEAR(measured_limit(euler, omega, zeta).dt, 2e-4 / 10, 1e-8);
  EXPECT_EQ(measured_limit(scheme("central-difference"), omega, zeta).deciding, 2);
  EXPECT_EQ(measured_limit(euler, omega, VectorXd::Zero(3)).dt, 0);
}

// Where theory has one: up to 1e6 of omega h, beyond which a limit is none.
TEST(StepLimit, IsThatOfTheFormulaWithinItsBar) {
  for (const Scheme& scheme : explicit_schemes())
    for (const double zeta : {0.0, 1e-6, 0.03, 1.0, 10.0, 300.0, 1e3, 1e5, 1e6, 1e8}) {
      const double formula = scheme.formula(zeta), measured = stable_omega_h(scheme, zeta);
      if (formula == 0 || formula > 1e6)
        EXPECT_EQ(measured, formula == 0 ? 0 : std::numeric_limits<double>::infinity()) << scheme.name << zeta;
      else
        EXPECT_LE(std::abs(measured / formula - 1), bar_of_limit(zeta)) << scheme.name << " " << zeta;
    }
  EXPECT_LT(bar_of_limit(100), 2e-9);
}

TEST(StepLimit, RefusesBadInput) {
  const Scheme& euler = scheme("explicit-euler");
  EXPECT_THROW(measured_limit(euler, VectorXd(), VectorXd()), std::invalid_argument);
  EXPECT_THROW(measured_limit(euler, omega, VectorXd(2)), std::invalid_argument);
  EXPECT_THROW(formula_limit(euler, VectorXd::Zero(3), VectorXd::Zero(3)), std::invalid_argument);
  EXPECT_THROW(with_lumped_mass(oscillators(omega, {})), std::invalid_argument);
}

// Growth of the catalogue's integrators, each from each mode, is rho^n within rounding.
TEST(GrowthRun, IsThatOfTheSpectralRadius) {
  const Catalogue catalogue = default_catalogue();
  for (const Rayleigh damping : {Rayleigh{0, 0}, Rayleigh{3, 0}, Rayleigh{0, 1e-4}, Rayleigh{3, 1e-4}}) {
    const System system = oscillators(omega, damping);
    const VectorXd zeta = ratios(omega, damping);
    for (const Scheme& scheme : explicit_schemes()) {
      if (!steps_as(scheme, system)) continue;
      for (Index i = 0; i < omega.size(); ++i) {
        const VectorXd e = VectorXd::Unit(3, i);
        const double limit = stable_omega_h(scheme, zeta(i)) / omega(i);
        for (const double factor : {0.5, 0.99, 1.01, 1.3}) {
          const double dt = factor * (limit > 0 ? limit : 0.1 / omega(i));
          const GrowthRun run =
              growth_run(system, {omega(i), zeta(i), e, e}, scheme, catalogue.integrator(scheme.integrator), dt, 5000);
          EXPECT_NEAR(run.observed / run.theory, 1, 1e-6) << scheme.name << " " << i << " " << factor;
          EXPECT_EQ(run.theory > 1 + 1e-9, factor > 1 || limit == 0) << scheme.name << " " << i << " " << factor;
        }
      }
    }
  }
}

TEST(GrowthRun, OfAMeshFollowsItsHighestMode) {
  const Catalogue catalogue = default_catalogue();
  for (const Rayleigh damping : {Rayleigh{0, 0}, Rayleigh{2, 0}, Rayleigh{0, 1e-5}}) {
    const System lumped = lumped_box(damping), consistent = with_consistent_mass(lumped);
    for (const System* system : {&lumped, &consistent}) {
      const SteppedMode top = highest_mode(system == &lumped ? with_lumped_mass(lumped) : consistent);
      for (const Scheme& scheme : explicit_schemes()) {
        if (!steps_as(scheme, *system)) continue;
        const double limit = stable_omega_h(scheme, top.zeta) / top.omega;
        for (const double factor : {0.99, 1.01}) {
          if (limit == 0) continue;
          const GrowthRun run =
              growth_run(*system, top, scheme, catalogue.integrator(scheme.integrator), factor * limit, 200);
          EXPECT_EQ(growth_verdict(run), "confirmed") << scheme.name << " " << factor << " " << damping.beta;
        }
      }
    }
  }
}

TEST(GrowthRun, IsNotConfirmedByARunThatNeitherGrowsNorDecays) {
  EXPECT_EQ(growth_verdict({1, 200, 1 + 1e-6, 1 + 1.005e-6}), "confirmed");
  EXPECT_EQ(growth_verdict({1, 200, 1 + 1e-6, 1}), "not confirmed");
  EXPECT_EQ(growth_verdict({1, 200, 1 + 1e-6, NAN}), "not confirmed");
  EXPECT_EQ(growth_verdict({1, 200, 1, 1 + 1e-9}), "confirmed");
  EXPECT_EQ(growth_verdict({1, 200, 1, 1 + 1e-7}), "not confirmed");
  EXPECT_EQ(growth_verdict({1, 200, 1 + 1e-9, 1 - 1e-9, 2}), "confirmed") << "it stays, but for rounding";
  EXPECT_EQ(growth_verdict({1, 200, 1 + 1e-9, 1 + 1e-9, 0.9}), "too short to tell");
  EXPECT_EQ(growth_verdict({1, 200, 1 + 1e-6, 1 + 1e-6, 0.9}), "confirmed") << "what grows is seen at any phase";
}

TEST(GrowthRun, DiffersFromTheoryWithinItsBarByRounding) {
  const GrowthRun none{1, 200, 1, 1 + 1e-10}, grown{1, 20, std::exp(5), std::exp(5.05)};
  EXPECT_NEAR(difference_of_logarithms(none), 1e-4, 1e-9);  // over 1e-6, as ln 1 = 0 divides nothing
  EXPECT_NEAR(bar_of_difference(none), 8e-4, 1e-12);
  EXPECT_NEAR(difference_of_logarithms(grown), 0.01, 1e-12);
  EXPECT_NEAR(bar_of_difference(grown), 1.6e-11, 1e-20);
}

TEST(StepLimits, OfModesThatDampingCouplesAreNotThoseOfOneMode) {
  const std::filesystem::path file = std::filesystem::path(MB_SOURCE_DIR) / "cases/hard/dashpot.toml";
  EXPECT_THROW(test::analysed("step-limits", read_toml(file, default_catalogue().vocabulary())), std::invalid_argument);
}

// At a damping ratio of 1e8 displacements hardly move: both eigenvalues are real, and one is 1 within rounding.
TEST(GrowthRun, OfAModeDampedBeyondAllMeasureIsSeen) {
  System system = oscillators(omega, {});
  system.modal_damping = {MatrixXd(VectorXd::Unit(3, 1)), VectorXd{{2 * 1e8 * omega(1)}}};
  const VectorXd e = VectorXd::Unit(3, 1);
  const Scheme& symplectic = scheme("symplectic-euler");
  for (const double factor : {0.99, 1.01}) {
    const double dt = factor * stable_omega_h(symplectic, 1e8) / omega(1);
    const GrowthRun run = growth_run(system, {omega(1), 1e8, e, e}, symplectic,
                                     default_catalogue().integrator("symplectic-euler"), dt, 200);
    EXPECT_EQ(growth_verdict(run), factor > 1 ? "confirmed" : "too short to tell") << factor << " " << run.observed;
    EXPECT_EQ(run.theory > 2, factor > 1) << run.theory;
  }
}

// With another scheme's theory the figures part: the comparison can fail.
TEST(GrowthRun, TellsSchemesApart) {
  const Rayleigh damping{0, 2e-3};
  const System system = oscillators(omega, damping);
  const VectorXd e = VectorXd::Unit(3, 2);
  const double zeta = ratios(omega, damping)(2);
  const Scheme& lagged = scheme("central-difference, lagged damping");
  EXPECT_FALSE(steps_as(lagged, system));
  const GrowthRun run =
      growth_run(system, {omega(2), zeta, e, e}, lagged, default_catalogue().integrator("central-difference"),
                 1.01 * stable_omega_h(lagged, zeta) / omega(2), 1000);
  EXPECT_GT(std::abs(run.observed / run.theory - 1), 0.5);
}

// Where cells are slivers or moved at random: the limit of a mesh is that of its highest mode.
TEST(HighestModeVerification, OfHardMeshesIsThatOfADenseSolver) {
  double off = 0;
  for (const char* name : {"sliver-mesh", "distorted-mesh"}) {
    const std::filesystem::path file =
        std::filesystem::path(MB_SOURCE_DIR) / "cases/hard" / (std::string(name) + ".toml");
    const auto scene = std::make_shared<const Scene>(read_toml(file, default_catalogue().vocabulary()));
    const Model model = make_model(scene, own_meshes(*scene));
    const System system = with_consistent_mass(model.bodies.front().full->system());
    const double lambda = generalized_eigenvalues(MatrixXd(system.K), MatrixXd(system.M)).value().maxCoeff();
    off = worse(off, std::abs(highest_mode(system).omega / std::sqrt(lambda) - 1));
  }
  testing::expect_verified({.quantity = "highest frequency of a mesh of slivers and of one whose corners are moved at "
                                        "random, relative, the worst",
                            .reference = "second route",
                            .source = "a dense solver of the whole matrix",
                            .uncertainty = "rounding",
                            .tolerance = 1e-12,
                            .why = "The eigenvalue is off by the square of the tolerance of Lanczos, 1e-7."},
                           off);
}

TEST(HighestMode, IsThatOfADenseSolver) {
  const System system = with_consistent_mass(lumped_box({1.5, 1e-4}));
  const double lambda = generalized_eigenvalues(MatrixXd(system.K), MatrixXd(system.M)).value().maxCoeff();
  const SteppedMode top = highest_mode(system);
  EXPECT_NEAR(top.omega, std::sqrt(lambda), 1e-9 * top.omega);
  EXPECT_NEAR(top.zeta, 1.5 / (2 * top.omega) + 1e-4 * top.omega / 2, 1e-9);
  EXPECT_NEAR(top.phi.dot(top.M_phi), 1, 1e-12);
  EXPECT_LT((system.K * top.phi - lambda * top.M_phi).norm(), 1e-4 * lambda * top.M_phi.norm());
}

}  // namespace
}  // namespace mb
