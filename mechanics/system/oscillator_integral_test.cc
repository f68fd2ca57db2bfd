#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "mechanics/geometry/gauss.h"
#include "mechanics/system/exp_difference.h"
#include "mechanics/system/oscillator.h"

namespace mb {
namespace {

constexpr std::size_t n_functions = 10;
using Functions = std::array<double, n_functions>;

Functions functions(const Response& x, const HarmonicResponse& y) {
  return {x.C, x.C_dot, x.S, x.S_dot, x.P, x.R, y.q_cos, y.q_sin, y.v_cos, y.v_sin};
}

Functions at(const Oscillator& oscillator, double Omega, double t) {
  return functions(response(oscillator, t), harmonic_response(oscillator, Omega, t));
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

// exp[a, b, c, d] is symmetric, and e^a/6 where all meet.
TEST(ExpDifferenceTest, FourNodes) {
  using Complex = std::complex<double>;
  const Complex a(-1, 2), b(0, 0.3), c(-40, 1), d(-1, 2.0000001);
  const Complex reference = exp_difference(a, b, c, d);
  EXPECT_LT(std::abs(exp_difference(d, c, b, a) - reference), 1e-14 * std::abs(reference));
  EXPECT_LT(std::abs(exp_difference(b, d, a, c) - reference), 1e-14 * std::abs(reference));
  EXPECT_LT(std::abs(exp_difference(a, a, a, a) - std::exp(a) / 6.0), 1e-15 * std::abs(std::exp(a)));
  const Complex far = (exp_difference(a, b, d) - exp_difference(b, c, d)) / (a - c);
  EXPECT_LT(std::abs(far - reference), 1e-13 * std::abs(reference));
}

}  // namespace
}  // namespace mb
