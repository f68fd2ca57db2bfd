#include "cases/exact/timoshenko_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/exact/exact_test_table.h"
#include "cases/exact/ode.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/contact/hertz.h"
#include "mechanics/contact/hertz_motion.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

// Timoshenko's first example as the table has it: both of steel, a ball of 1 cm radius on 1 x 1 x 15.35 cm at 1 cm/s.
BeamImpact timoshenko() {
  const Material steel{215.7463e9, 0.3, 7960};
  const double side = 0.01, r = 0.01;
  return {0.1535,
          steel.youngs_modulus * std::pow(side, 4) / 12,
          steel.density * side * side,
          4 * pi / 3 * r * r * r * steel.density,
          hertz_stiffness({r, contact_modulus(steel, steel)}),
          0.01};
}

// Columns: t, F, ball, midspan. Written with nine digits, computed with steps of 5e-8 s: with those the march meets
// its digits, extrapolated it parts from it by the table's own error, 8e-6 of the peak.
TEST(TimoshenkoImpactVerification, Table) {
  const auto table = numbers("timoshenko1913_A_EB.csv");
  ASSERT_EQ(table.size(), 1001u);
  const BeamMotion same = march_beam_impact(timoshenko(), {2e-6, 1000, 40, 160});
  const BeamMotion motion = beam_impact(timoshenko(), {2e-6, 1000, 40, 160});
  const double peak = 4.97714, greatest = 7e-7;  // [N], [m] of the ball while in contact
  double worst = 0;
  for (Index j = 0; j <= 1000; ++j) {
    const auto& row = table[static_cast<std::size_t>(j)];
    ASSERT_NEAR(motion.t[j], row[0], 1e-15);
    EXPECT_NEAR(motion.force[j], row[1], 8e-6 * peak) << row[0];
    EXPECT_NEAR(motion.ball[j], row[2], 1e-6 * greatest) << row[0];
    EXPECT_NEAR(motion.midspan[j], row[3], 8e-6 * greatest) << row[0];
    EXPECT_NEAR(same.force[j], row[1], 1e-8 * peak) << row[0];
    EXPECT_NEAR(same.ball[j], row[2], 1e-9 * greatest) << row[0];
    EXPECT_NEAR(same.midspan[j], row[3], 1e-9 * greatest) << row[0];
    worst = worse(worst, std::abs(motion.force[j] - row[1]) / peak);
  }
  testing::expect_verified(
      {.quantity = "force between a steel ball and a simply supported beam, largest error over 2 ms, over its peak",
       .reference = "table",
       .source = "Timoshenko's first example (1913) in another program: timoshenko1913_A_EB.csv",
       .uncertainty = "8e-6, the table's steps of 5e-8 s",
       .tolerance = 8e-6,
       .why = "Extrapolated in its steps the march parts from the table by the table's own error; with the table's "
              "steps it meets its digits."},
      worst);
}

// Beside the table: one contact, peak 4.97714 N at 72.6 us, ends 156.5 us (at its first step without force, 156.45 us),
// impulse 4.342311e-4 N s, rebound 3.02324 mm/s.
TEST(TimoshenkoImpactVerification, FiguresBesideTheTable) {
  const BeamMotion motion = beam_impact(timoshenko(), {2e-6, 1000, 40, 160});
  EXPECT_EQ(motion.n_contacts, 1);
  EXPECT_NEAR(motion.peak, 4.97714, 0.51e-5);
  EXPECT_NEAR(motion.peak_time, 72.6e-6, 0.051e-6);
  EXPECT_NEAR(motion.touch_end, 156.5e-6, 0.1e-6);
  EXPECT_NEAR(motion.impulse, 4.342311e-4, 1e-10);
  EXPECT_NEAR(motion.rebound_speed, 3.02324e-3, 0.51e-8);
}

// Halved steps: errors fall by four; extrapolated by 2^2.5 at least.
TEST(TimoshenkoImpactTest, IsOfSecondOrder) {
  const auto peak = [](Index n, auto march) { return march(timoshenko(), {2e-6, 100, n, 40}).force; };
  const VectorXd truth = peak(80, beam_impact);
  double before = 0, better = 0;
  for (const Index n : {4, 8, 16}) {
    const double error = (peak(n, march_beam_impact) - truth).norm(),
                 extrapolated = (peak(n, beam_impact) - truth).norm();
    if (n > 4) {
      EXPECT_NEAR(std::log2(before / error), 2, 0.05) << n;
      EXPECT_GT(std::log2(better / extrapolated), 2.2) << n;
    }
    EXPECT_LT(extrapolated, error / 10);
    before = error, better = extrapolated;
  }
}

// The differential equations of ball and modes, by extrapolation in time, instead of their convolution.
TEST(TimoshenkoImpactVerification, DifferentialEquations) {
  const BeamImpact impact = timoshenko();
  const Index n_modes = 4;
  const double modal = 2 / (impact.mass_per_length * impact.length), us = 1e-6, um = impact.speed * us;
  VectorXd k(n_modes);
  for (Index n = 0; n < n_modes; ++n)
    k[n] = std::pow((2 * static_cast<double>(n) + 1) * pi / impact.length, 4) * impact.bending_stiffness /
           impact.mass_per_length * us * us;
  // in microseconds and the lengths the ball flies in one: ball, modes' parts of the midspan, then their rates
  const Derivative f = [&](double, const VectorXd& y) {
    const double w = std::max(y[0] - y.segment(1, n_modes).sum(), 0.0) * um;
    const double a = impact.contact_stiffness * std::pow(w, 1.5) * us * us / um;
    VectorXd rate(2 * n_modes + 2);
    rate.head(n_modes + 1) = y.tail(n_modes + 1);
    rate[n_modes + 1] = -a / impact.ball_mass;
    rate.tail(n_modes) = VectorXd::Constant(n_modes, modal * a) - k.cwiseProduct(y.segment(1, n_modes));
    return rate;
  };
  OdeState state{0, VectorXd::Zero(2 * n_modes + 2)};
  state.y[n_modes + 1] = 1;
  const BeamMotion motion = beam_impact(impact, {2e-6, 75, 100, n_modes});
  double worst = 0;
  for (const Index j : {5, 20, 36, 50, 75}) {  // up to 150 us, in contact
    state = integrate(f, state, 2 * static_cast<double>(j), {1e-11, 1e-13});
    const double midspan = state.y.segment(1, n_modes).sum();
    EXPECT_NEAR(motion.ball[j] / um, state.y[0], 1e-8 * 60) << j;
    EXPECT_NEAR(motion.midspan[j] / um, midspan, 1e-8 * 60) << j;
    const double force = impact.contact_stiffness * std::pow((state.y[0] - midspan) * um, 1.5);
    EXPECT_NEAR(motion.force[j], force, 1e-7 * motion.peak) << j;
    worst = worse(worst, std::abs(motion.force[j] - force) / motion.peak);
  }
  testing::expect_verified(
      {.quantity = "force between a ball and a beam of four modes, at five times in contact, over its peak",
       .reference = "second route",
       .source = "differential equations of ball and modes by extrapolation in time (cases/exact/ode.h)",
       .uncertainty = "about 1e-9, steps held to 1e-11 each",
       .tolerance = 1e-7,
       .why = "Ball and midspan agree to 1e-8; the power 3/2 of their difference loses a digit."},
      worst);
}

// What the ball loses, the beam has: nothing stays in the contact.
TEST(TimoshenkoImpactTest, ConservesEnergy) {
  const BeamImpact impact = timoshenko();
  const BeamMotion motion = beam_impact(impact, {2e-6, 100, 40, 60});
  const double before = impact.ball_mass * impact.speed * impact.speed / 2;
  const double after = impact.ball_mass * motion.rebound_speed * motion.rebound_speed / 2 + motion.beam_energy;
  EXPECT_NEAR(after, before, 1e-8 * before);
  EXPECT_NEAR(motion.impulse, impact.ball_mass * (impact.speed + motion.rebound_speed), 1e-15 * motion.impulse);
}

// A beam 1e8 times as heavy and stiff is a wall.
TEST(TimoshenkoImpactVerification, HeavyBeamIsHertz) {
  BeamImpact impact = timoshenko();
  impact.bending_stiffness *= 1e8;
  impact.mass_per_length *= 1e8;
  const HertzImpact hertz{impact.ball_mass, impact.contact_stiffness, impact.speed};
  const HertzPeaks peaks = hertz_peaks(hertz);
  const BeamMotion motion = beam_impact(impact, {peaks.duration / 50, 60, 200, 20});
  const HertzMotion exact = hertz_motion(hertz, motion.t);
  EXPECT_LT((motion.force - exact.force).cwiseAbs().maxCoeff(), 1e-6 * peaks.force);
  EXPECT_LT((motion.ball - exact.approach).cwiseAbs().maxCoeff(), 1e-6 * peaks.approach);
  EXPECT_NEAR(motion.peak, peaks.force, 1e-6 * peaks.force);
  EXPECT_NEAR(motion.peak_time, peaks.duration / 2, 1e-6 * peaks.duration);
  EXPECT_NEAR(motion.touch_end, peaks.duration, 1e-6 * peaks.duration);
  EXPECT_NEAR(motion.rebound_speed, impact.speed, 1e-6 * impact.speed);
}

// A ball of twice the beam's mass goes on downwards and is met again; and a march that ends within the contact says so.
TEST(TimoshenkoImpactTest, HeavyBallStrikesMoreThanOnce) {
  BeamImpact impact = timoshenko();
  impact.ball_mass *= 8;
  EXPECT_GT(beam_impact(impact, {2e-6, 1000, 10, 60}).n_contacts, 1);
  const BeamMotion cut = beam_impact(timoshenko(), {2e-6, 50, 20, 60});  // ends within the contact
  EXPECT_NEAR(cut.touch_end, 100e-6, 1e-18);
  EXPECT_GT(cut.peak, 4.9);
  EXPECT_EQ(cut.n_contacts, 1);
}

TEST(TimoshenkoImpactTest, RefusesBadInput) {
  const BeamMarch march{1e-6, 2, 2, 2};
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (double BeamImpact::*member :
         {&BeamImpact::length, &BeamImpact::bending_stiffness, &BeamImpact::mass_per_length, &BeamImpact::ball_mass,
          &BeamImpact::contact_stiffness, &BeamImpact::speed}) {
      BeamImpact impact = timoshenko();
      impact.*member = bad;
      EXPECT_THROW(beam_impact(impact, march), std::invalid_argument);
    }
    EXPECT_THROW(march_beam_impact(timoshenko(), {bad, 2, 2, 2}), std::invalid_argument);
  }
  EXPECT_THROW(beam_impact(timoshenko(), {1e-6, 0, 2, 2}), std::invalid_argument);
  EXPECT_THROW(beam_impact(timoshenko(), {1e-6, 2, 0, 2}), std::invalid_argument);
  EXPECT_THROW(beam_impact(timoshenko(), {1e-6, 2, 2, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace mb
