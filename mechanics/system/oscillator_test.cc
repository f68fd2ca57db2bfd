#include "mechanics/system/oscillator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "mechanics/types.h"

namespace mb {
namespace {

using Row = std::vector<std::string>;

// Rows below the comment and the heading.
std::vector<Row> rows(const std::string& name) {
  std::ifstream file(std::string(MB_SOURCE_DIR "/cases/exact/tables/") + name);
  std::vector<Row> result;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::stringstream cells(line);
    Row row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    result.push_back(row);
  }
  if (!result.empty()) result.erase(result.begin());
  return result;
}

double number(const std::string& cell) { return std::strtod(cell.c_str(), nullptr); }  // reads hexadecimal as well

// |error| over its gate 1e-14 (1 + t) scale max(1, |reference|/scale), omega = 1: the phase omega t is rounded, and an
// answer is judged against its own size or the largest it can have by then, so that returning 0 fails.
double over_gate(double got, const std::string& reference, double t, double scale) {
  const long double exact = std::strtold(reference.c_str(), nullptr);
  const double size = std::max(scale, std::abs(static_cast<double>(exact)));
  return static_cast<double>(std::abs(got - exact)) / (1e-14 * (1 + t) * size);
}

double over_gates(const Response& x, const Row& row, double t) {
  const double early = std::min(t, 1.0);
  return std::max({over_gate(x.C, row[4], t, 1), over_gate(x.C_dot, row[5], t, early), over_gate(x.S, row[6], t, early),
                   over_gate(x.S_dot, row[7], t, 1), over_gate(x.P, row[8], t, early * early / 2),
                   over_gate(x.S, row[9], t, early), over_gate(x.R, row[10], t, early * early * early / 6)});
}

TEST(OscillatorVerification, ReferenceTable) {
  const auto table = rows("sdof_reference.csv");
  ASSERT_EQ(table.size(), 253u);
  for (const auto& row : table) {
    const double zeta = number(row[1]), t = number(row[3]);
    EXPECT_LE(over_gates(response(1.0, zeta, t), row, t), 1) << "zeta " << row[0] << ", t " << row[2];
    // 2 zeta is exact, so that (k, c) states the same problem
    EXPECT_LE(over_gates(response(Oscillator{1, 2 * zeta}, t), row, t), 1) << "zeta " << row[0] << ", t " << row[2];
  }
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
    const Response x = response(Oscillator{0, number(row[1])}, number(row[2]));
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

Phase follow(const Oscillator& oscillator, const std::vector<Segment>& pieces, double t) {
  Phase state{0, 0};
  for (const auto& piece : pieces) {
    if (t <= piece.end) return propagate(oscillator, state, 1, piece, t - piece.start);
    state = propagate(oscillator, state, 1, piece, piece.end - piece.start);
  }
  return state;
}

TEST(OscillatorVerification, PulseTable) {
  const auto table = rows("sdof_pulses.csv");
  ASSERT_EQ(table.size(), 240u);
  for (const auto& row : table) {
    const double zeta = number(row[0]), duration = number(row[2]), t = number(row[3]), forever = 1e6;
    const std::vector<Segment> half_sine = {{0, duration, 0, 0, 0, 1, pi / duration}, {duration, forever}};
    const std::vector<Segment> ramp = {{0, duration, 0, 1 / duration}, {duration, forever, 1}};
    const Phase state = follow({1, 2 * zeta}, row[1] == "half-sine" ? half_sine : ramp, t);
    const double early = std::min(t, 1.0);  // 3: both pieces, and the state between them, are rounded
    EXPECT_LE(over_gate(state.q, row[4], t, early * early / 2), 3)
        << row[1] << " " << zeta << " " << duration << " " << t;
  }
}

// Largest |q| on [from, to]: at an end or where v changes its sign.
double largest(const Oscillator& oscillator, const std::vector<Segment>& pieces, double from, double to) {
  const auto at = [&](double t) { return follow(oscillator, pieces, t); };
  constexpr int n_intervals = 4000;
  double result = std::max(std::abs(at(from).q), std::abs(at(to).q));
  for (int i = 0; i < n_intervals; ++i) {
    double a = from + (to - from) * i / n_intervals, b = from + (to - from) * (i + 1) / n_intervals;
    const double v_a = at(a).v;
    if (v_a * at(b).v > 0) continue;
    for (int bisection = 0; bisection < 40; ++bisection) (at(0.5 * (a + b)).v * v_a > 0 ? a : b) = 0.5 * (a + b);
    result = std::max(result, std::abs(at(a).q));
  }
  return result;
}

TEST(OscillatorVerification, ShockSpectrumOfAHalfSine) {
  const auto table = rows("srs_halfsine.csv");
  ASSERT_EQ(table.size(), 80u);
  for (const auto& row : table) {
    const double zeta = number(row[0]), R = number(row[1]), omega = 2 * pi * R;  // duration 1 s
    const Oscillator oscillator{omega * omega, 2 * zeta * omega};
    const std::vector<Segment> pulse = {{0, 1, 0, 0, 0, omega * omega, pi}, {1, 1e6}};
    const double primary = largest(oscillator, pulse, 0, 1), residual = largest(oscillator, pulse, 1, 1 + 1.5 / R);
    EXPECT_NEAR(primary, number(row[2]), 2e-9) << "zeta " << zeta << ", R " << R;  // nine decimals are printed
    EXPECT_NEAR(residual, number(row[3]), 2e-9) << "zeta " << zeta << ", R " << R;
    EXPECT_NEAR(std::max(primary, residual), number(row[4]), 2e-9) << "zeta " << zeta << ", R " << R;
  }
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

// Gate: 2e-14 (1 + (omega + Omega) t) of the largest response to a unit load by then: t'^2/2, for the velocity t'.
double error_over_gate(const Oscillator& oscillator, double Omega, double t) {
  const auto got = harmonic_response(oscillator, Omega, t), exact = duhamel(oscillator, Omega, t);
  const double omega = std::sqrt(oscillator.k), early = std::min(t, 1 / std::max(omega, 1e-300));
  const double gate = 2e-14 * (1 + (omega + Omega) * t);
  const double q_size = std::max({0.5 * early * early, std::abs(exact.q_cos), std::abs(exact.q_sin)});
  const double v_size = std::max({early, std::abs(exact.v_cos), std::abs(exact.v_sin)});
  return std::max({std::abs(got.q_cos - exact.q_cos) / q_size, std::abs(got.q_sin - exact.q_sin) / q_size,
                   std::abs(got.v_cos - exact.v_cos) / v_size, std::abs(got.v_sin - exact.v_sin) / v_size}) /
         gate;
}

TEST(OscillatorTest, HarmonicLoadMatchesDuhamelsIntegral) {
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
      const auto x = harmonic_response(Oscillator{omega * omega, 0}, omega, t);
      const double gate = 1e-14 * (1 + omega * t) * t / omega;
      EXPECT_NEAR(x.q_cos, t * std::sin(omega * t) / (2 * omega), gate);
      EXPECT_NEAR(x.v_cos, (std::sin(omega * t) / omega + t * std::cos(omega * t)) / 2, gate * omega);
      EXPECT_NEAR(x.v_sin, t * std::sin(omega * t) / 2, gate * omega);
    }
}

TEST(OscillatorTest, StiffModesStayFinite) {
  for (double zeta : {0.0, 1.0, 1e8})
    for (double omega : {1e6, 1e9}) {
      const Oscillator stiff{omega * omega, 2 * zeta * omega};
      const Phase state = propagate(stiff, {1, 1}, 1, {0, 20, 1, 1, 1, 1, 3}, 10);
      EXPECT_TRUE(std::isfinite(state.q) && std::isfinite(state.v)) << zeta << " " << omega;
    }
  // settled, it follows the load: k q = s
  const double omega = 1e6;
  const Segment load{0, 20, 1, 0.5, 0.25, 0, 3};
  EXPECT_NEAR(omega * omega * propagate({omega * omega, 2 * omega}, {1, 1}, 1, load, 10).q, value(load, 10), 1e-4);
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
    const Phase start{unit(random), unit(random)}, once = propagate(oscillator, start, 2, load, t);
    const Phase middle = propagate(oscillator, start, 2, load, share * t);
    const Phase twice = propagate(oscillator, middle, 2, rebased(load, share * t, t), t - share * t);
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
  EXPECT_THROW(response(1.0, -0.1, 1.0), std::invalid_argument);
  EXPECT_THROW(response(std::numeric_limits<double>::infinity(), 0.1, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace mb
