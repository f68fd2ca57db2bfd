#include "cases/exact/zener_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "cases/exact/exact_test_table.h"
#include "cases/exact/ode.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/contact/hertz.h"
#include "mechanics/contact/hertz_motion.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

// Columns: lambda, e, duration, peak force, exp(-1.719 lambda); written with 7, 6, 7 and 5 digits after the point.
TEST(ZenerImpactVerification, Table) {
  const auto table = numbers("zener_restitution.csv");
  ASSERT_EQ(table.size(), 21u);
  double worst = 0;
  for (const auto& row : table) {
    const ZenerImpact impact = zener_impact(row[0]);
    EXPECT_NEAR(impact.restitution, row[1], 0.51e-7) << row[0];
    EXPECT_NEAR(impact.duration, row[2], 0.51e-6) << row[0];
    EXPECT_NEAR(impact.peak_force, row[3], 0.51e-7) << row[0];
    EXPECT_NEAR(impact.restitution, row[4], 0.02) << row[0];  // the usual fit, good to a hundredth and a half
    worst = worse(worst, std::abs(impact.restitution - row[1]));
  }
  testing::expect_verified({.quantity = "restitution of a ball on a large plate at 21 values of Zener's parameter",
                            .reference = "table",
                            .source = "Zener's equation (1941) in another program: zener_restitution.csv",
                            .uncertainty = "5e-8, the table's seven digits after the point",
                            .tolerance = 0.51e-7,
                            .why = "Half of the table's last digit, and a fiftieth of that."},
                           worst);
}

// lambda = 0 is Hertz's impact, which mechanics/ solves by quadrature instead.
TEST(ZenerImpactVerification, RigidPlateIsHertz) {
  const HertzPeaks hertz = hertz_peaks({1, 1, 1});
  const ZenerImpact impact = zener_impact(0);
  EXPECT_NEAR(impact.restitution, 1, 1e-12);
  EXPECT_NEAR(impact.duration, hertz.duration, 1e-12);
  EXPECT_NEAR(impact.peak_force, hertz.force, 1e-12);
  EXPECT_NEAR(impact.peak_time, hertz.duration / 2, 1e-12);
  const VectorXd tau = VectorXd::LinSpaced(83, -0.4, 4);
  const ZenerMotion motion = zener_motion(0, tau);
  const HertzMotion exact = hertz_motion({1, 1, 1}, tau);
  MatrixXd off(tau.size(), 3);
  off << motion.sigma - exact.approach, motion.rate - exact.rate, motion.force - exact.force;
  testing::expect_verified(
      {.quantity = "approach, its rate and force of an impact on a rigid plate at 83 times, in Zener's units",
       .reference = "second route",
       .source = "Hertz's impact by its energy integral (mechanics/contact/hertz_motion.h)",
       .uncertainty = "1e-13, quadrature and rounding",
       .tolerance = 1e-12,
       .why = "Steps of Zener's equation are held to 1e-13 each; their sum is allowed ten times that."},
      off.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

// What is lost works on the plate: e = 1 - int F dtau, and energy: 1 - e^2 = 2 lambda int F^2 dtau.
TEST(ZenerImpactTest, BalancesMomentumAndEnergy) {
  for (const double lambda : {0.05, 0.4, 1.0, 2.0}) {
    const ZenerImpact impact = zener_impact(lambda);
    const Index n = 400;
    const ZenerMotion motion = zener_motion(lambda, VectorXd::LinSpaced(n + 1, 0, impact.duration));
    const double w = impact.duration / static_cast<double>(n);  // trapezoidal: ends like t^(3/2) err by w^2
    const double impulse = w * motion.force.sum(), work = w * lambda * motion.force.squaredNorm();
    EXPECT_NEAR(1 + impact.restitution, impulse, 2e-5);
    EXPECT_NEAR((1 - impact.restitution * impact.restitution) / 2, work, 2e-5);
    EXPECT_NEAR(motion.force.maxCoeff(), impact.peak_force, 1e-4);
    const VectorXd ball = motion.rate + lambda * motion.force;  // the ball's speed falls steadily
    for (Index i = 0; i < n; ++i) EXPECT_LE(ball[i + 1], ball[i] + 1e-13);
  }
}

// Sigma = lambda^-4 S(tau/lambda) late in a heavily damped contact, whence e lambda^5 tends to a number.
TEST(ZenerImpactTest, HeavyDampingIsSelfSimilar) {
  const auto scaled = [](double lambda) { return zener_impact(lambda).restitution * std::pow(lambda, 5); };
  const double limit = scaled(50);
  EXPECT_NEAR(limit, 0.679, 0.001);
  EXPECT_NEAR(scaled(25), limit, 1e-6);
  EXPECT_NEAR(scaled(10), limit, 1e-4);
  double before = 1;
  for (double lambda = 0.5; lambda < 20; lambda *= 1.7) {
    const double e = zener_impact(lambda).restitution;
    EXPECT_LT(e, before);
    before = e;
  }
}

// The same number from Zener's own grouping of the data.
TEST(ZenerImpactVerification, ParameterFromMaterials) {
  const Material steel{207e9, 0.29, 7850}, glass{70e9, 0.22, 2500};
  for (const auto& impact :
       {PlateImpact{steel, glass, 0.004, 0.009, 1.7}, PlateImpact{glass, steel, 0.03, 0.002, 0.2}}) {
    const double E1 = contact_modulus(impact.ball), E2 = contact_modulus(impact.plate);
    const double c = std::sqrt(E2 / impact.plate.density);
    const double expected = std::pow(pi, 0.6) / std::sqrt(3) * std::pow(impact.radius / impact.thickness, 2) *
                            std::pow(impact.speed / c, 0.2) *
                            std::pow(impact.ball.density / impact.plate.density, 0.6) * std::pow(E1 / (E1 + E2), 0.4);
    EXPECT_NEAR(zener_parameter(impact), expected, 1e-14 * expected);
    const double m = 4 * pi / 3 * std::pow(impact.radius, 3) * impact.ball.density;
    const HertzPeaks peaks = hertz_peaks({m, hertz_stiffness({impact.radius, E1 * E2 / (E1 + E2)}), impact.speed});
    EXPECT_NEAR(zener_impact(0).duration * zener_time(impact), peaks.duration, 1e-12 * peaks.duration);
  }
}

TEST(ZenerImpactTest, RefusesBadInput) {
  for (const double bad : {-1e-9, 51.0, std::nan("")}) EXPECT_THROW(zener_impact(bad), std::invalid_argument);
  EXPECT_THROW(zener_motion(1, VectorXd{{1.0, 0.5}}), std::invalid_argument);
  EXPECT_THROW(zener_motion(1, VectorXd{{1.0, std::nan("")}}), std::invalid_argument);
  const Material steel{207e9, 0.29, 7850};
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(zener_parameter({steel, steel, bad, 1, 1}), std::invalid_argument);
    EXPECT_THROW(zener_parameter({steel, steel, 1, bad, 1}), std::invalid_argument);
    EXPECT_THROW(zener_parameter({steel, steel, 1, 1, bad}), std::invalid_argument);
    EXPECT_THROW(zener_time({steel, {1e9, 0.3, bad}, 1, 1, 1}), std::invalid_argument);
    EXPECT_THROW(zener_time({{bad, 0.3, 1}, steel, 1, 1, 1}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace mb
