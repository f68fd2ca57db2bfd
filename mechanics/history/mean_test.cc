#include "mechanics/history/mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

constexpr double pi = 3.14159265358979323846;

// Of s by Gauss's rule of two points on many intervals: independent of the segments.
double by_quadrature(const History& history, double a, double b) {
  constexpr int n = 20000;
  const auto s = evaluator(history);
  const double h = (b - a) / n, offset = 0.5 / std::sqrt(3.0);
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (const double at : {0.5 - offset, 0.5 + offset}) {
      const double t = a + (i + at) * h;
      if (t >= 0) sum += s(t);
    }
  return sum / (2 * n);
}

double mean_of(const History& history, double a, double b, double tolerance = 1e-6) {
  return mean(b > 0 ? segments(history, b, tolerance) : Segments{}, a, b);
}

TEST(Mean, OfEveryKindOfHistory) {
  const std::vector<History> histories = {Step{2, 0.3},
                                          Pulse{0.5, 3, 0.1},
                                          Ramp{0.4, 2, 0.2},
                                          Harmonic{7, 0.4, 1.5, 0.25},
                                          Chirp{3, 40, 0.8, 1, 0.1},
                                          Table{{0.1, 0.3, 0.9}, {1, -2, 0.5}},
                                          Expression{"exp(-t)*sin(5*t)"}};
  for (const History& history : histories)
    for (const auto& [a, b] : {std::pair{0.05, 0.95}, {0.31, 0.33}, {0.0, 1.0}, {-0.2, 0.2}, {0.85, 0.97}})
      // Jumps cost the quadrature half an interval, 2.5e-5 of the window, times the jump, at most 2.
      EXPECT_NEAR(mean_of(history, a, b, 1e-7), by_quadrature(history, a, b), 6e-5) << history.index() << " " << a;
}

TEST(Mean, IsExactInClosedForm) {
  EXPECT_NEAR(mean_of(Pulse{0.5, 3}, 0, 0.5), 1.5, 1e-15);       // of sin^2 over its arch: a half
  EXPECT_NEAR(mean_of(Step{4}, -0.1, 0.3), 3, 1e-15);            // a quarter of the window before the load
  EXPECT_NEAR(mean_of(Harmonic{2 * pi}, 0.25, 1.25), 0, 1e-15);  // whole period
  EXPECT_NEAR(mean_of(Ramp{2, 2}, 0, 1), 0.5, 1e-15);
  EXPECT_NEAR(mean_of(Harmonic{3}, 0.4, 0.4 + 1e-9), std::sin(1.2), 1e-8);  // a short window is the value
  EXPECT_EQ(mean_of(Step{4}, -2, -1), 0);
}

TEST(Mean, RefusesBadIntervals) {
  const Segments chain = segments(Step{}, 1);
  EXPECT_NO_THROW(mean(chain, 0.5, 1 + 1e-15));
  EXPECT_THROW(mean(chain, 0.5, 1.1), std::invalid_argument);
  EXPECT_THROW(mean(chain, 0.5, 0.5), std::invalid_argument);
  EXPECT_THROW(mean(chain, 0.6, 0.5), std::invalid_argument);
  EXPECT_THROW(mean(chain, NAN, 0.5), std::invalid_argument);
  EXPECT_THROW(mean(chain, 0, INFINITY), std::invalid_argument);
}

}  // namespace
}  // namespace mb
