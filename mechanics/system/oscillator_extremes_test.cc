// Every response at damping ratios of exactly 1 - ulp, 1, 1 + ulp and 1e8, where the roots meet or lie 16 decades
// apart, each over its own size, however small.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>

#include "mechanics/system/oscillator_test.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using testing::number;
using testing::Row;
using testing::rows;

using Pair = std::complex<double>;  // answers to a cosine and a sine

struct Extreme {
  explicit Extreme(const Row& row)
      : zeta(number(row.at(1))), Omega(number(row.at(3))), t(number(row.at(5))), d(number(row.at(14))) {}
  double zeta, Omega, t, d;
  double phase() const { return 1 + (1 + Omega) * t; }  // omega t and Omega t are rounded, omega = 1
  // |1/(k - Omega^2 + i c Omega)| of the steady answer, once it has come about: after full periods nothing may be left
  // of an overdamped one but what its phase is rounded by.
  double steady() const { return Omega * t < 1 ? 0 : 1 / std::hypot(1 - Omega * Omega, 2 * zeta * Omega); }
};

// |error| over the size of both answers of the pair, or a given one: nothing is judged against what it might have been
// without damping.
double off(const Pair& got, const Row& row, size_t column, double least_size) {
  const long double re = std::strtold(row[column].c_str(), nullptr),
                    im = std::strtold(row[column + 1].c_str(), nullptr);
  const long double size = std::max<long double>(std::hypot(re, im), least_size);
  return static_cast<double>(std::hypot(got.real() - re, got.imag() - im) / size);
}
double off(double got, const Row& row, size_t column) {
  const long double exact = std::strtold(row[column].c_str(), nullptr);
  return static_cast<double>(std::abs(got - exact) / std::abs(exact));
}

double harmonic_and_integrals(const Row& row) {
  const Extreme at(row);
  const Roots r = roots({1, 2 * at.zeta});
  const Response free = response(r, at.t), summed = integral(r, free, at.t);
  const HarmonicResponse wave = harmonic_response(r, free, at.Omega, at.t);
  const HarmonicResponse mean = integral(r, free, wave, at.Omega, at.t);
  const double q = at.steady(), v = at.Omega * q, summed_q = q / at.Omega;
  return VectorXd{{off({wave.q_cos, wave.q_sin}, row, 6, q), off({wave.v_cos, wave.v_sin}, row, 8, v),
                   off({mean.q_cos, mean.q_sin}, row, 10, summed_q), off({mean.v_cos, mean.v_sin}, row, 6, q),
                   off(summed.C, row, 12), off(summed.R, row, 13)}}
             .maxCoeff<Eigen::PropagateNaN>() /
         at.phase();
}

// Free, after an impulse, under a step and a ramp. What has decayed below all doubles is 0.
double free_motion(const Row& row) {
  const double zeta = number(row.at(1)), t = number(row.at(3));
  const Response x = response(roots({1, 2 * zeta}), t);
  const double got[] = {x.C, x.C_dot, x.S, x.S_dot, x.P, x.S, x.R};
  double worst = 0;
  for (size_t i = 0; i < 7; ++i) {
    const long double exact = std::strtold(row.at(4 + i).c_str(), nullptr);
    long double size = std::max(std::abs(exact), 1e-290L);
    if (i == 3 && zeta < 2) size += std::abs(std::strtold(row[6].c_str(), nullptr));  // passes 0 where S is largest
    worst = VectorXd{{worst, static_cast<double>(std::abs(got[i] - exact) / size)}}.maxCoeff<Eigen::PropagateNaN>();
  }
  return worst / (1 + t);
}

// Half a sine is two of them, the second from the end of the first on: over the size of either.
double half_sine(const Row& row) {
  const Extreme at(row);
  std::vector<History> loads{Harmonic{at.Omega}};
  if (at.t > at.d) loads.push_back(Harmonic{.omega = at.Omega, .start = at.d});
  const double got = testing::one_mode({1, 2 * at.zeta}, loads, 1, 40)->run(VectorXd::Constant(1, at.t)).u(0, 0);
  const long double exact = std::strtold(row.at(15).c_str(), nullptr);
  const double size = std::max(std::hypot(number(row[6]), number(row[7])), at.steady());
  return static_cast<double>(std::abs(got - exact)) / size / at.phase();
}

const double ulp = std::numeric_limits<double>::epsilon();
const std::vector<double> extremes{1 - ulp / 2, 1, 1 + ulp, 1e8};

TEST(OscillatorVerification, FreeMotionAtExtremesOfDamping) {
  double worst = 0;
  int n = 0;
  for (const Row& row : rows("sdof_reference.csv")) {
    if (std::ranges::find(extremes, number(row[1])) == extremes.end()) continue;
    const double off = free_motion(row);
    EXPECT_LE(off, 2e-15) << "zeta " << row[0] << ", t " << row[2];
    worst = VectorXd{{worst, off}}.maxCoeff<Eigen::PropagateNaN>();
    ++n;
  }
  EXPECT_EQ(n, 44);
  testing::expect_verified(
      {.quantity = "responses of an oscillator, free, to an impulse, a step and a ramp, over their own size and 1 + "
                   "omega t; damping ratios 1 - ulp, 1, 1 + ulp and 1e8",
       .reference = "table",
       .source = "closed forms in 60-digit arithmetic in another program: sdof_reference.csv",
       .uncertainty = "1e-25, the table's digits",
       .tolerance = 2e-15,
       .why = "Nine roundings: the phase omega t is rounded, and nothing may cancel where roots meet."},
      worst);
}

TEST(OscillatorVerification, ForcedMotionAtExtremesOfDamping) {
  const auto table = rows("sdof_extremes.csv");
  ASSERT_EQ(table.size(), 120u);
  double worst = 0;
  std::map<double, int> seen;
  for (const Row& row : table) {
    const double waves = harmonic_and_integrals(row), pulse = half_sine(row);
    EXPECT_LE(waves, 5e-15) << "zeta " << row[1] << ", Omega " << row[2] << ", t " << row[4];
    EXPECT_LE(pulse, 5e-15) << "zeta " << row[1] << ", Omega " << row[2] << ", t " << row[4];
    worst = VectorXd{{worst, waves, pulse}}.maxCoeff<Eigen::PropagateNaN>();
    ++seen[number(row[1])];
  }
  for (const double zeta : extremes) EXPECT_EQ(seen[zeta], 30) << zeta;
  testing::expect_verified(
      {.quantity =
           "answers of an oscillator to a cosine, a sine and half a sine, and integrals of them, of free motion "
           "and of the answer to a ramp, over their own size and 1 + (omega + Omega) t; damping ratios 1 - ulp, "
           "1, 1 + ulp and 1e8",
       .reference = "table",
       .source = "closed forms in 400-digit arithmetic in another program: sdof_extremes.csv",
       .uncertainty = "1e-25, the table's digits",
       .tolerance = 5e-15,
       .why = "22 roundings: phases are rounded, and differences of up to four nodes lose a digit where two meet."},
      worst);
}

// The answers at a ratio a hundredth of a per cent off are refused.
TEST(OscillatorVerification, ExtremesAreTold) {
  for (Row row : rows("sdof_extremes.csv")) {
    row[1] = fmt::format("{:a}", number(row[1]) * (1 + 1e-4));
    EXPECT_GT(harmonic_and_integrals(row), 5e-15) << row[1];
  }
}

}  // namespace
}  // namespace mb
