#include "mechanics/system/oscillator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "mechanics/extended_precision_test.h"
#include "mechanics/system/modal_motion.h"
#include "mechanics/system/oscillator_test.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using testing::number;
using testing::one_mode;
using testing::Row;
using testing::rows;

// |error| over its gate 1e-14 (1 + t) scale max(1, |reference|/scale), omega = 1: the phase omega t is rounded, and an
// answer is judged against its own size or the largest it can have by then, so that returning 0 fails.
double over_gate(double got, const std::string& reference, double t, double scale) {
  const long double exact = std::strtold(reference.c_str(), nullptr);
  const double size = std::max(scale, std::abs(static_cast<double>(exact)));
  return static_cast<double>(std::abs(got - exact)) / (1e-14 * (1 + t) * size);
}

double over_gates(const Response& x, const Row& row, double t) {
  const double early = std::min(t, 1.0);
  return VectorXd{{over_gate(x.C, row[4], t, 1), over_gate(x.C_dot, row[5], t, early), over_gate(x.S, row[6], t, early),
                   over_gate(x.S_dot, row[7], t, 1), over_gate(x.P, row[8], t, early * early / 2),
                   over_gate(x.S, row[9], t, early), over_gate(x.R, row[10], t, early * early * early / 6)}}
      .maxCoeff<Eigen::PropagateNaN>();  // std::max would drop one
}

TEST(OscillatorVerification, ReferenceTable) {
  const auto table = rows("sdof_reference.csv");
  ASSERT_EQ(table.size(), 253u);
  double worst = 0;
  for (const auto& row : table) {
    const double zeta = number(row[1]), t = number(row[3]), off = over_gates(response(roots({1, 2 * zeta}), t), row, t);
    EXPECT_LE(off, 1) << "zeta " << row[0] << ", t " << row[2];
    worst = std::max(worst, off);
  }
  testing::expect_verified(
      {.quantity =
           "responses of an oscillator, free, to an impulse, a step and a ramp, over 1 + omega t and the larger "
           "of their size and what they may reach by then; damping ratios 0 to 1e8, 1 +- 1 ulp among them",
       .reference = "table",
       .source = "closed forms in 60-digit arithmetic in another program: sdof_reference.csv",
       .uncertainty = "1e-25, the table's digits",
       .tolerance = 1e-14,
       .why = "45 roundings: the phase omega t is rounded, and nothing may cancel where roots meet."},
      1e-14 * worst);
}

TEST(OscillatorVerification, GateRefusesZeros) {
  const auto table = rows("sdof_reference.csv");
  ASSERT_FALSE(table.empty());
  for (const auto& row : table) EXPECT_GT(over_gates({}, row, number(row[3])), 1);
}

TEST(OscillatorVerification, RigidModeTable) {
  const auto table = rows("sdof_rigid_mode.csv");
  ASSERT_EQ(table.size(), 66u);
  for (const auto& row : table) {
    const Response x = response(roots({0, number(row[1])}), number(row[2]));
    const double got[] = {x.S, x.S_dot, x.P, x.S};
    for (std::size_t i = 0; i < 4; ++i) {
      const long double exact = std::strtold(row[3 + i].c_str(), nullptr);
      const long double tiny = std::numeric_limits<double>::min();  // e^-100000 is not a double
      EXPECT_LE(std::abs(got[i] - exact), std::max(4e-15L * std::abs(exact), tiny))
          << "a " << row[0] << ", t " << row[2];
    }
    EXPECT_EQ(x.C, 1);
    EXPECT_EQ(x.C_dot, 0);
  }
}

// Half a sine is two of them, the second from the end of the first on.
std::vector<History> half_sine(double duration) {
  return {Harmonic{pi / duration}, Harmonic{.omega = pi / duration, .start = duration}};
}

TEST(OscillatorVerification, PulseTable) {
  const auto table = rows("sdof_pulses.csv");
  ASSERT_EQ(table.size(), 240u);
  for (const auto& row : table) {
    const double zeta = number(row[0]), duration = number(row[2]), t = number(row[3]);
    const auto loads = row[1] == "half-sine" ? half_sine(duration) : std::vector<History>{Ramp{duration}};
    const double q = one_mode({1, 2 * zeta}, loads, 1, 25)->run(VectorXd::Constant(1, t)).u(0, 0);
    const double early = std::min(t, 1.0);  // 3: both pieces, and the state between them, are rounded
    EXPECT_LE(over_gate(q, row[4], t, early * early / 2), 3) << row[1] << " " << zeta << " " << duration << " " << t;
  }
}

// Largest |q| on [from, to]: at an end or where v changes its sign. There the times are taken a second time, as dense
// between two of the first: omega times what is left between them is below 1e-5, its square below the table's digits.
double largest(const Stepper& stepper, double from, double to, bool again = true) {
  const States states = stepper.run(VectorXd::LinSpaced(4001, from, to));
  double result = states.u.cwiseAbs().maxCoeff();
  const double step = (to - from) / 4000;
  for (Index i = 0; again && i < 4000; ++i)
    if (states.v(0, i) * states.v(0, i + 1) <= 0)
      result = std::max(result, largest(stepper, from + static_cast<double>(i) * step,
                                        std::min(from + static_cast<double>(i + 1) * step, to), false));
  return result;
}

TEST(OscillatorVerification, ShockSpectrumOfAHalfSine) {
  const auto table = rows("srs_halfsine.csv");
  ASSERT_EQ(table.size(), 80u);
  double worst = 0;
  for (const auto& row : table) {
    const double zeta = number(row[0]), R = number(row[1]), omega = 2 * pi * R, end = 1 + 1.5 / R;  // duration 1 s
    const auto stepper = one_mode({omega * omega, 2 * zeta * omega}, half_sine(1), omega * omega, end);
    const double primary = largest(*stepper, 0, 1), residual = largest(*stepper, 1, end);
    EXPECT_NEAR(primary, number(row[2]), 2e-9) << "zeta " << zeta << ", R " << R;  // nine decimals are printed
    EXPECT_NEAR(residual, number(row[3]), 2e-9) << "zeta " << zeta << ", R " << R;
    EXPECT_NEAR(std::max(primary, residual), number(row[4]), 2e-9) << "zeta " << zeta << ", R " << R;
    worst = std::max({worst, std::abs(primary - number(row[2])), std::abs(residual - number(row[3]))});
  }
  testing::expect_verified(
      {.quantity =
           "shock spectrum of half a sine, during and after it, over the static response; damping ratios 0 to 0.1",
       .reference = "table",
       .source = "maxima of closed forms in another program: srs_halfsine.csv",
       .uncertainty = "5e-10, nine decimals",
       .tolerance = 2e-9,
       .why = "Nine decimals on one side; on the other maxima between samples, missed by less than 1e-10."},
      worst);
}

// Duhamel's integral of S(t - s) e^{i Omega s} in long double, S by the textbook formulas: Gauss-Legendre, 10 points an
// interval no longer than the fastest time scale: its error is (1/2)^20/20! of the integrand, below long double's.
HarmonicResponse duhamel(const Oscillator& oscillator, double Omega, double t) {
  using Real = long double;
  static const Real x[] = {0.1488743389816312108848L, 0.4333953941292471907993L, 0.6794095682990244062343L,
                           0.8650633666889845107321L, 0.9739065285171717200780L};
  static const Real w[] = {0.2955242247147528701739L, 0.2692667193099963550912L, 0.2190863625159820439955L,
                           0.1494513491505805931458L, 0.0666713443086881375936L};
  const Real k = oscillator.k, h = oscillator.c / 2.0L, gap = h * h - k, mu = std::sqrt(std::abs(gap));
  const auto S = [&](Real s) {
    if (gap == 0) return s * std::exp(-h * s);
    return std::exp(-h * s) * (gap < 0 ? std::sin(mu * s) : std::sinh(mu * s)) / mu;
  };
  const auto S_dot = [&](Real s) {
    if (gap == 0) return (1 - h * s) * std::exp(-h * s);
    return std::exp(-h * s) * (gap < 0 ? std::cos(mu * s) : std::cosh(mu * s)) - h * S(s);
  };
  const int n = 1 + static_cast<int>(t * std::max({Omega, std::sqrt(oscillator.k), oscillator.c}));
  Real sums[4] = {};
  for (int i = 0; i < n; ++i) {
    for (int j = -5; j < 5; ++j) {
      const std::size_t node = static_cast<std::size_t>(j < 0 ? -j - 1 : j);
      const Real half = static_cast<Real>(t) / n / 2, s = half * (2 * i + 1 + (j < 0 ? -x[node] : x[node]));
      const Real cosine = std::cos(Omega * s), sine = std::sin(Omega * s);
      const Real q = half * w[node] * S(t - s), v = half * w[node] * S_dot(t - s);
      sums[0] += q * cosine, sums[1] += q * sine, sums[2] += v * cosine, sums[3] += v * sine;
    }
  }
  return {static_cast<double>(sums[0]), static_cast<double>(sums[1]), static_cast<double>(sums[2]),
          static_cast<double>(sums[3])};
}

HarmonicResponse wave(const Oscillator& oscillator, double Omega, double t) {
  const Roots r = roots(oscillator);
  return harmonic_response(r, response(r, t), Omega, t);
}

// Gate: 2e-14 (1 + (omega + Omega) t) of the largest response to a unit load by then: t'^2/2, for the velocity t'.
double error_over_gate(const Oscillator& oscillator, double Omega, double t) {
  const auto got = wave(oscillator, Omega, t), exact = duhamel(oscillator, Omega, t);
  const double omega = std::sqrt(oscillator.k), early = std::min(t, 1 / std::max(omega, 1e-300));
  const double gate = 2e-14 * (1 + (omega + Omega) * t);
  const double q_size = std::max({0.5 * early * early, std::abs(exact.q_cos), std::abs(exact.q_sin)});
  const double v_size = std::max({early, std::abs(exact.v_cos), std::abs(exact.v_sin)});
  return std::max({std::abs(got.q_cos - exact.q_cos) / q_size, std::abs(got.q_sin - exact.q_sin) / q_size,
                   std::abs(got.v_cos - exact.v_cos) / v_size, std::abs(got.v_sin - exact.v_sin) / v_size}) /
         gate;
}

TEST(OscillatorTest, HarmonicLoadMatchesDuhamelsIntegral) {
  if (!is_long_double_wider()) GTEST_SKIP() << "the integral overflows in double";
  for (double omega : {0.0, 0.01, 1.0, 30.0})
    for (double zeta : {0.0, 1e-6, 0.02, 0.5, 1 - 1e-15, 1.0, 1 + 1e-15, 1.5, 20.0})
      for (double ratio : {0.0, 1e-3, 0.5, 1 - 1e-3, 1 - 1e-9, 1.0, 1 + 1e-12, 1 + 1e-6, 1.1, 3.0, 40.0})
        for (double t : {1e-6, 0.01, 0.3, 1.0, 4.0}) {
          const double reference = omega > 0 ? omega : 1.0;
          const Oscillator oscillator{omega * omega, 2 * zeta * reference};
          EXPECT_LE(error_over_gate(oscillator, ratio * reference, t), 1)
              << "omega " << omega << ", zeta " << zeta << ", Omega/omega " << ratio << ", t " << t;
        }
}

TEST(OscillatorTest, UndampedResonanceGrowsLinearly) {
  for (double omega : {1.0, 37.0})
    for (double t : {1e-3, 1.0, 50.0}) {
      const auto x = wave({omega * omega, 0}, omega, t);
      const double gate = 1e-14 * (1 + omega * t) * t / omega;
      EXPECT_NEAR(x.q_cos, t * std::sin(omega * t) / (2 * omega), gate);
      EXPECT_NEAR(x.v_cos, (std::sin(omega * t) / omega + t * std::cos(omega * t)) / 2, gate * omega);
      EXPECT_NEAR(x.v_sin, t * std::sin(omega * t) / 2, gate * omega);
    }
}

struct Phase {
  double q, v;
};
// State at t of a mode that starts with start0 under f times a segment that starts at 0.
Phase follow(const Oscillator& oscillator, const Phase& start, double f, const Segment& load, double t) {
  const ModalMotion motion{{roots(oscillator)},
                           MatrixXd::Constant(1, 1, f),
                           VectorXd::Constant(1, start.q),
                           VectorXd::Constant(1, start.v),
                           {{load.start, load.end, {load}}}};
  const ModalStates end = states(motion, VectorXd::Constant(1, t));
  return {end.q(0, 0), end.v(0, 0)};
}

TEST(OscillatorTest, StiffModesStayFinite) {
  for (double zeta : {0.0, 1.0, 1e8})
    for (double omega : {1e6, 1e9}) {
      const Phase state = follow({omega * omega, 2 * zeta * omega}, {1, 1}, 1, {0, 20, 1, 1, 1, 1, 3}, 10);
      EXPECT_TRUE(std::isfinite(state.q) && std::isfinite(state.v)) << zeta << " " << omega;
    }
  // settled, it follows the load: k q = s
  const double omega = 1e6;
  const Segment load{0, 20, 1, 0.5, 0.25, 0, 3};
  EXPECT_NEAR(omega * omega * follow({omega * omega, 2 * omega}, {1, 1}, 1, load, 10).q, value(load, 10), 1e-4);
}

// Any split of a segment gives the same state: holds together all twelve functions, their signs and derivatives.
TEST(OscillatorTest, TwoStepsEqualOne) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto spread = [&](double low, double high) { return low * std::pow(high / low, unit(random)); };
  for (int i = 0; i < 2000; ++i) {
    const double omega = spread(1e-3, 1e3), zeta = spread(1e-4, 1e2), t = spread(1e-3, 1e1), share = unit(random);
    const Segment load{0, t, unit(random), unit(random), unit(random), unit(random), omega * spread(0.1, 10)};
    const Oscillator oscillator{omega * omega, 2 * zeta * omega};
    const Phase start{unit(random), unit(random)}, once = follow(oscillator, start, 2, load, t);
    const Phase middle = follow(oscillator, start, 2, load, share * t);
    Segment rest = rebased(load, share * t, t);
    rest.start = 0, rest.end = t - share * t;
    const Phase twice = follow(oscillator, middle, 2, rest, t - share * t);
    const double early = std::min(t, 1 / omega), forces = 2 * (1 + t + std::sqrt(2));
    const double size = 1 + early * (1 + omega) + early * early * forces;  // of q; v is omega or 1/early times as large
    const double gate = 2e-13 * (1 + (omega + load.omega) * t);
    EXPECT_NEAR(once.q, twice.q, gate * size);
    EXPECT_NEAR(once.v, twice.v, gate * (1 + omega + early * forces));
  }
}

TEST(OscillatorTest, BadInput) {
  EXPECT_THROW(roots({-1, 0}), std::invalid_argument);
  EXPECT_THROW(roots({1, -1e-3}), std::invalid_argument);
  EXPECT_THROW(roots({std::nan(""), 0}), std::invalid_argument);
  EXPECT_THROW(roots({1, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(roots({std::numeric_limits<double>::infinity(), 0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace mb
