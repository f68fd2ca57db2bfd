#include "harness/analysis/energy_drift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "harness/catalogue.h"
#include "mechanics/system/oscillators_test.h"

namespace mb {
namespace {

const VectorXd omega{{3, 40, 200}};  // [rad/s]
constexpr double dt = 2 * pi / 20 / 200;
constexpr Index n_steps = 100'000;
constexpr double loss = 1e-6;  // [-] of the energy at the start, a step

// Exact vibration whose energy falls by the same amount every step.
class Losing : public Stepper {
 public:
  explicit Losing(double step) : step_(step) {}
  States run(const VectorXd& times) const override {
    States states;
    states.u.resize(omega.size(), times.size()), states.v.resize(omega.size(), times.size());
    for (Index k = 0; k < times.size(); ++k) {
      const double left = std::sqrt(1 - loss * times[k] / step_);
      states.u.col(k) = left * (omega * times[k]).array().cos() / omega.array();
      states.v.col(k) = -left * (omega * times[k]).array().sin();
    }
    return states;
  }

 private:
  double step_;
};

Integrator made_by(decltype(Integrator::prepare) prepare) { return {"test", "", prepare}; }

TEST(EnergyDrift, FindsAKnownLossAndItsExponent) {
  const Integrator losing = made_by([](const System&, const Settings& s, double) -> std::unique_ptr<Stepper> {
    return std::make_unique<Losing>(s.time_step);
  });
  const EnergyDrift found = energy_drift(losing, test::oscillators(omega, {2, 1e-4}), dt, n_steps);
  EXPECT_EQ(found.status, Status::ok);
  EXPECT_NEAR(found.swing, loss * drift_window, 1e-12);
  const double first = 1 - loss * (drift_window + 1) / 2;  // the mean of the first window, whose weights are symmetric
  EXPECT_NEAR(found.drift, -loss * (n_steps - drift_window) / first, 1e-12);
  const double first_of_half = 1 - loss * (1.5 * drift_window + 1) / 2;
  EXPECT_NEAR(found.bar, 3. / 7 * loss * (n_steps - drift_window) * std::abs(1 / first - 1 / first_of_half), 1e-12);
  EXPECT_NEAR(found.law.exponent, 1, 1e-9);
  EXPECT_EQ(found.law.n_points, 6);
}

// Of damping that it leaves out nothing is seen, and schemes that keep the energy of linear systems keep it.
TEST(EnergyDrift, OfSchemesThatConserveIsRounding) {
  const Catalogue catalogue = default_catalogue();
  for (const char* name : {"newmark", "exact"}) {
    const EnergyDrift found =
        energy_drift(catalogue.integrator(name), test::oscillators(omega, {2, 1e-4}), dt, n_steps);
    EXPECT_EQ(found.status, Status::ok) << name;
    EXPECT_LT(std::abs(found.drift), 1e-10) << name;  // 1e5 roundings, all of one sign, are 2e-11
    EXPECT_LT(found.swing, 1e-10) << name;
    EXPECT_GE(found.bar, std::numeric_limits<double>::epsilon()) << name << ": no luck of two windows";
  }
}

// What swings without a drift is seen as one by what its windows let through: less than their bar.
TEST(EnergyDrift, OfASwingLiesWithinItsBar) {
  const Catalogue catalogue = default_catalogue();
  for (int i = 0; i < 20; ++i) {
    const VectorXd swinging = VectorXd{{35, 60, 110, 200}} * (1 + 0.002 * i);
    const EnergyDrift found =
        energy_drift(catalogue.integrator("symplectic-euler"), test::oscillators(swinging, {}), dt, 10'000);
    EXPECT_GT(found.swing, 0.05);
    EXPECT_LT(std::abs(found.drift), found.bar) << i;
    EXPECT_LT(found.bar, 1e-4) << i;
  }
}

// Energy grows by 1 + omega^2 dt^2 a step.
TEST(EnergyDrift, OfExplicitEulerIsThatOfItsFormula) {
  const double w = 1e-3 / dt;
  const EnergyDrift found = energy_drift(default_catalogue().integrator("explicit-euler"),
                                         test::oscillators(VectorXd::Constant(1, w), {}), dt, 20000);
  EXPECT_NEAR(std::log1p(found.drift), (20000 - drift_window) * std::log1p(1e-6), 1e-9);
  EXPECT_NEAR(found.law.exponent, 1, 0.01);  // growth is exponential, 2 % over the run
}

// Of what vanished nothing is left that an index could be relative to.
class Ending : public Stepper {
  States run(const VectorXd& times) const override {
    States states;
    states.u = MatrixXd::Zero(omega.size(), times.size());
    states.v = MatrixXd::Zero(omega.size(), times.size());
    states.v.leftCols(drift_window).setOnes();
    return states;
  }
};
TEST(EnergyDrift, OfEnergyThatVanishedHasNoBar) {
  const Integrator ending = made_by(
      [](const System&, const Settings&, double) -> std::unique_ptr<Stepper> { return std::make_unique<Ending>(); });
  const EnergyDrift found = energy_drift(ending, test::oscillators(omega, {}), dt, n_steps);
  EXPECT_EQ(found.drift, -1);
  EXPECT_TRUE(std::isnan(found.bar));
}

TEST(EnergyDrift, SaysWhatWentWrong) {
  const EnergyDrift found =
      energy_drift(default_catalogue().integrator("explicit-euler"), test::oscillators(omega, {}), 1, n_steps);
  EXPECT_EQ(found.status, Status::not_finite);
  EXPECT_TRUE(std::isnan(found.drift) && std::isnan(found.bar) && std::isnan(found.swing) &&
              std::isnan(found.law.exponent));
}

TEST(EnergyDrift, RefusesBadInput) {
  const Catalogue catalogue = default_catalogue();
  const Integrator& newmark = catalogue.integrator("newmark");
  const System system = test::oscillators(omega, {});
  EXPECT_THROW(energy_drift(newmark, system, dt, 2 * drift_window), std::invalid_argument);
  for (const double bad : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(energy_drift(newmark, system, bad, n_steps), std::invalid_argument);
  System rigid = test::oscillators(VectorXd{{0, 0}}, {});
  rigid.R = MatrixXd::Identity(2, 2);
  EXPECT_THROW(energy_drift(newmark, rigid, dt, n_steps), std::invalid_argument);
}

}  // namespace
}  // namespace mb
