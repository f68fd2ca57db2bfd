#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "mechanics/geometry/gauss.h"
#include "mechanics/system/exp_difference.h"
#include "mechanics/system/oscillator.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr std::size_t n_functions = 10;
using Functions = std::array<double, n_functions>;

Functions functions(const Response& x, const HarmonicResponse& y) {
  return {x.C, x.C_dot, x.S, x.S_dot, x.P, x.R, y.q_cos, y.q_sin, y.v_cos, y.v_sin};
}

Functions at(const Oscillator& oscillator, double Omega, double t) {
  const Roots r = roots(oscillator);
  const Response free = response(r, t);
  return functions(free, harmonic_response(r, free, Omega, t));
}

Functions integrals(const Oscillator& oscillator, double Omega, double t) {
  const Roots r = roots(oscillator);
  const Response free = response(r, t);
  return functions(integral(r, free, t), integral(r, free, harmonic_response(r, free, Omega, t), Omega, t));
}

// Gauss's rule on panels that shrink towards 0, where over-damped modes are fast; of f and of |f|.
struct Quadrature {
  Functions value{}, size{};
};
Quadrature quadrature(const Oscillator& oscillator, double Omega, double t) {
  static const Rule rule = gauss_legendre(10);
  Quadrature result;
  const auto panel = [&](double a, double b) {
    for (Index i = 0; i < rule.x.size(); ++i) {
      const Functions f = at(oscillator, Omega, a + (b - a) * rule.x[i]);
      for (std::size_t j = 0; j < n_functions; ++j) {
        result.value[j] += (b - a) * rule.w[i] * f[j];
        result.size[j] += (b - a) * rule.w[i] * std::abs(f[j]);
      }
    }
  };
  const double rate = std::sqrt(oscillator.k) + Omega;  // the fast root has decayed but on the first panels
  double start = 0;
  for (int level = 30; level >= 0; --level) {
    const double end = std::ldexp(t, -level);
    const int n = 1 + static_cast<int>((end - start) * rate / 2);
    for (int i = 0; i < n; ++i) panel(start + (end - start) * i / n, start + (end - start) * (i + 1) / n);
    start = end;
  }
  return result;
}

TEST(OscillatorIntegralTest, MatchesQuadratureInEveryRegime) {
  for (const double zeta : {0.0, 1e-3, 0.5, 1 - 1e-9, 1.0, 1 + 1e-6, 1.4, 6.0})
    for (const double omega : {0.0, 1e-7, 0.02, 1.0, 30.0})
      for (const double Omega : {1e-6, 1e-3, 0.7, omega > 0 ? omega : 2.0, omega * (1 + 1e-7) + 1e-9, 11.0})
        for (const double t : {1e-6, 0.1, 1.5, 4.0}) {
          const Oscillator oscillator{omega * omega, 2 * zeta * omega};
          const Functions closed = integrals(oscillator, Omega, t);
          const Quadrature expected = quadrature(oscillator, Omega, t);
          for (std::size_t j = 0; j < n_functions; ++j) {
            // A wave is complex: its sine is as sharp as its cosine is large. Phases omega t up to 120 are rounded.
            const double size = expected.size[j] + (j < 6 ? 0 : expected.size[j % 2 == 0 ? j + 1 : j - 1]);
            EXPECT_NEAR(closed[j], expected.value[j], 1e-13 * (1 + (omega + Omega) * t) * size)
                << "function " << j << ", zeta " << zeta << ", omega " << omega << ", Omega " << Omega << ", t " << t;
          }
        }
}

TEST(OscillatorIntegralTest, StiffModesStayFinite) {
  for (const double zeta : {0.0, 1.0, 1e8})
    for (const double Omega : {1e-3, 3.0, 1e6})
      for (const double x : integrals({1e12, 2e6 * zeta}, Omega, 10)) EXPECT_TRUE(std::isfinite(x));
}

using Complex = std::complex<double>;

// Cauchy's formula: exp[z1 ... zn] = 1/(2 pi i) oint e^z / prod (z - z_i) dz. On a circle the trapezoidal rule
// converges by (distance of the farthest node)/radius a point; its terms are a few hundred times the answer, as
// extended precision bears.
Complex by_cauchy(const std::vector<Complex>& nodes) {
  using Extended = std::complex<long double>;
  const auto by_real = [](Complex y, Complex z) { return y.real() < z.real(); };
  const auto [left, right] = std::minmax_element(nodes.begin(), nodes.end(), by_real);
  const Extended centre = (Extended(*left) + Extended(*right)) / 2.0L;
  long double radius = 0;
  for (const Complex z : nodes) radius = std::max(radius, std::abs(Extended(z) - centre) + 4);
  constexpr int n_points = 1000;
  Extended sum = 0;
  for (int k = 0; k < n_points; ++k) {
    const Extended offset = std::polar(radius, 2 * std::numbers::pi_v<long double> * k / n_points);
    Extended term = std::exp(centre + offset) * offset;
    for (const Complex z : nodes) term /= centre + offset - Extended(z);
    sum += term / static_cast<long double>(n_points);
  }
  return Complex(sum);
}

// Nodes far apart, near each other, and one and the same, in any order: 9 roundings (seen 3.4).
TEST(ExpDifferenceVerification, IsCauchysIntegral) {
  const Complex a(-1, 2), b(0, 0.3), c(-40, 1), d(-1, 2.0000001), o(0, 0);
  double worst = 0;
  const auto compare = [&](const Complex& got, const std::vector<Complex>& nodes) {
    const Complex expected = by_cauchy(nodes);
    const double off = std::abs(got - expected) / std::abs(expected);
    EXPECT_LT(off, 2e-15) << ::testing::PrintToString(nodes);
    worst = std::max(worst, off);
  };
  for (const Complex x : {a, b, c, d, o})
    for (const Complex y : {a, b, c, d, o}) {
      compare(exp_difference(x, y), {x, y});
      for (const Complex z : {a, b, c, d, o}) {
        compare(exp_difference(x, y, z), {x, y, z});
        for (const Complex w : {a, b, c, d, o}) compare(exp_difference(x, y, z, w), {x, y, z, w});
      }
    }
  testing::expect_verified({.quantity = "divided differences of the exponential at 2 to 4 complex nodes, 0 to 40 apart",
                            .reference = "second route",
                            .source = "Cauchy's integral in extended precision, 1000 points on a circle",
                            .uncertainty = "1e-16, rounding of the result to double precision",
                            .tolerance = 2e-15,
                            .why = "Nine roundings; the recursion loses no more than a digit in a step."},
                           worst);
  EXPECT_LT(std::abs(exp_difference(a, a, a, a) - std::exp(a) / 6.0), 1e-15 * std::abs(std::exp(a)));
}

}  // namespace
}  // namespace mb
