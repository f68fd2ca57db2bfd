#include "harness/analysis/step_damping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/catalogue.h"
#include "mechanics/system/oscillators_test.h"

namespace mb {
namespace {

using test::oscillators;

const VectorXd omega{{3, 40, 200}};  // [rad/s]
const std::vector<std::string> fixed_steps{"newmark", "central-difference", "explicit-euler", "symplectic-euler"};

TEST(StepDamping, OfUndampedSchemesIsThatOfClosedForms) {
  for (const double x : {1e-3, 0.1, 0.7, 1.5}) {
    const double log_modulus = std::log1p(x * x) / 2, Omega = std::hypot(log_modulus, std::atan(x));
    EXPECT_NEAR(step_damping(scheme("explicit-euler"), x, 0), -log_modulus / Omega, 1e-14) << x;
    for (const char* neutral : {"newmark", "central-difference", "symplectic-euler"})
      EXPECT_NEAR(step_damping(scheme(neutral), x, 0), 0, 1e-14) << neutral << x;
  }
  EXPECT_NEAR(step_damping(scheme("explicit-euler"), 1e-4, 0), -0.5e-4, 1e-8);  // -omega h / 2 at small steps
}

TEST(StepDamping, TendsToTheRatioAtTheOrderOfTheScheme) {
  for (const auto& [name, order] : {std::pair("newmark", 2), std::pair("central-difference", 2),
                                    std::pair("explicit-euler", 1), std::pair("central-difference, lagged damping", 1)})
    for (const double zeta : {0.01, 0.3}) {
      const auto error = [&](double x) { return std::abs(step_damping(scheme(name), x, zeta) - zeta); };
      EXPECT_NEAR(std::log2(error(2e-3) / error(1e-3)), order, 0.02) << name << zeta;
    }
}

TEST(StepDamping, IsThatOfGrowthBeyondTheLimitAndNoneWhereNothingSwings) {
  EXPECT_LT(step_damping(scheme("central-difference"), 2.1, 0.01), -0.05);
  EXPECT_GT(step_damping(scheme("central-difference"), 1.9, 0.01), 0);
  EXPECT_TRUE(std::isnan(step_damping(scheme("newmark"), 1, 1e8)));  // eigenvalues 1 - 1e-8 and 1e-8 - 1
}

// Through critical damping and beyond, where an ulp more or less changes nothing.
TEST(StepDamping, GoesOnWhereTheAnswerCreeps) {
  const double below = std::nextafter(1.0, 0.0), above = std::nextafter(1.0, 2.0);
  for (const char* name : {"newmark", "central-difference"}) {
    for (const double zeta : {below, 1.0, above})
      EXPECT_NEAR(step_damping(scheme(name), 1e-2, zeta), 1, 1e-4) << name << zeta;
    const auto error = [&](double x) { return std::abs(step_damping(scheme(name), x, 1.5) - 1.5); };
    EXPECT_NEAR(std::log2(error(2e-2) / error(1e-2)), 2, 0.02) << name;
  }
}

// The integrators themselves, each mode beside others.
TEST(StepDamping, IsThatOfRuns) {
  const Catalogue catalogue = default_catalogue();
  for (const bool lumped : {false, true})
    for (const Rayleigh damping : {Rayleigh{0, 0}, Rayleigh{2, 0}, Rayleigh{0, 1e-3}, Rayleigh{2, 1e-3}}) {
      const System system = oscillators(omega, damping, lumped);
      const VectorXd zeta = damping.alpha / (2 * omega.array()) + damping.beta * omega.array() / 2;
      for (const std::string& name : fixed_steps) {
        const Scheme* scheme = scheme_of(name, system);
        if (!scheme) continue;  // lumped and damped by both: of neither kind
        for (Index i = 0; i < omega.size(); ++i)
          for (const double x : {0.003, 0.2, 1.1, 2.3}) {
            const VectorXd e = VectorXd::Unit(omega.size(), i);
            const double theory = step_damping(*scheme, x, zeta(i));
            const double run = run_damping(system, {omega(i), zeta(i), e, e}, catalogue.integrator(name), x / omega(i));
            EXPECT_NEAR(run, theory, 1e-10) << scheme->name << " " << i << " " << x << " " << damping.beta;
          }
      }
    }
}

// Beyond critical damping, where a run shows its fast state for a short while only.
TEST(StepDamping, IsThatOfRunsThatCreep) {
  const Catalogue catalogue = default_catalogue();
  for (const double ratio : {1.0, 1.5, 5.0, 20.0, 100.0}) {
    const System system = oscillators(VectorXd::Constant(1, 1), {2 * ratio, 0}, false);
    const VectorXd e = VectorXd::Ones(1);
    for (const double x : {0.001, 0.01, 0.05}) {
      const double theory = step_damping(*scheme_of("newmark", system), x, ratio);
      const double run = run_damping(system, {1, ratio, e, e}, catalogue.integrator("newmark"), x);
      const bool fast_is_gone = 2 * ratio * x > 1;  // within a step
      if (fast_is_gone)
        EXPECT_TRUE(std::isnan(run) || std::abs(run / theory - 1) < 1e-2) << ratio << " " << x << " " << run;
      else
        EXPECT_NEAR(run / theory, 1, 1e-7) << ratio << " " << x;
    }
  }
  const System stiff = oscillators(VectorXd::Constant(1, 1), {200, 0}, false);  // zeta 100: alternating, far from done
  const VectorXd e = VectorXd::Ones(1);
  EXPECT_TRUE(std::isnan(run_damping(stiff, {1, 100, e, e}, catalogue.integrator("newmark"), 0.05)));
}

// Both eigenvalues -1: the undamped limit of central differences, of which a step takes nothing.
TEST(StepDamping, IsNoneAtTheLimitItself) {
  EXPECT_NEAR(step_damping(scheme("central-difference"), 2, 0), 0, 1e-7);
  for (const double zeta : {1e4, 1e6, 1e7})
    EXPECT_NEAR(step_damping(scheme("newmark"), 1e-9, zeta) / zeta, 1, 1e-3) << zeta;  // slow roots near 1e-16
}

// Textbook reading of the same run: logarithm of two peaks of one decay, many periods apart.
TEST(StepDamping, IsTheLogarithmicDecrementOfALongDecay) {
  const double h = 0.05, w = 1;
  const System system = oscillators(VectorXd::Constant(1, w), {0.04, 0}, false);
  Settings settings;
  settings.time_step = h;
  for (const std::string& name : fixed_steps) {
    System alone = let_go(system, VectorXd::Ones(1));
    const auto stepper = default_catalogue().integrator(name).prepare(alone, settings, 80);
    const States states = stepper->run(VectorXd::LinSpaced(1601, 0, 80));
    const VectorXd u = states.u.row(0);
    std::vector<double> peaks, times;
    for (Index k = 1; k + 1 < u.size(); ++k)
      if (u(k) > u(k - 1) && u(k) >= u(k + 1)) {  // by the parabola through three samples
        const double slope = (u(k + 1) - u(k - 1)) / 2, bend = u(k + 1) - 2 * u(k) + u(k - 1);
        peaks.push_back(u(k) - slope * slope / (2 * bend));
        times.push_back(static_cast<double>(k) - slope / bend);
      }
    ASSERT_GE(peaks.size(), 8u) << name;
    const double decrement = std::log(peaks[0] / peaks.back()) / static_cast<double>(peaks.size() - 1);
    const double by_peaks = decrement / std::hypot(2 * pi, decrement);
    EXPECT_NEAR(by_peaks, step_damping(*scheme_of(name, system), w * h, 0.02), 1e-4) << name;
    EXPECT_EQ(by_peaks < 0, name == "explicit-euler") << name;  // 0.02 - omega h / 2
  }
}

TEST(StepDamping, SchemesAreThoseOfTheSystem) {
  EXPECT_EQ(scheme_of("central-difference", oscillators(omega, {0, 1e-3}, true))->name,
            "central-difference, lagged damping");
  EXPECT_EQ(scheme_of("central-difference", oscillators(omega, {0, 1e-3}, false))->name, "central-difference");
  EXPECT_EQ(scheme_of("sundials", oscillators(omega, {}, false)), nullptr);
}

TEST(StepDamping, RefusesBadInput) {
  for (const double bad : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(step_damping(scheme("newmark"), bad, 0), std::invalid_argument);
  for (const double bad : {-1.0, std::nan("")})
    EXPECT_THROW(step_damping(scheme("newmark"), 1, bad), std::invalid_argument);
  const VectorXd e = VectorXd::Unit(3, 2);  // overflows: not finite
  EXPECT_TRUE(std::isnan(run_damping(oscillators(omega, {}, false), {omega(2), 0, e, e},
                                     default_catalogue().integrator("explicit-euler"), 1e200)));
}

}  // namespace
}  // namespace mb
