// Exact means over time, of the closed-form stepper.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/geometry/gauss.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/exact_test_systems.h"
#include "mechanics/system/newmark.h"

namespace mb {
namespace {

constexpr double duration = 3;

// Means by Gauss's rule between breakpoints, on panels short against the shortest period, 1 s.
States quadrature(const System& system, const VectorXd& times, double width) {
  const auto stepper = exact(system, duration);
  const Rule rule = gauss_legendre(8);
  States means;
  means.u = means.v = MatrixXd::Zero(system.M.rows(), times.size());
  for (Index j = 0; j < times.size(); ++j) {
    const double start = std::max(0.0, times[j] - width / 2), end = times[j] + width / 2;
    means.u.col(j) = std::max(0.0, width / 2 - times[j]) / width * system.u0;
    std::vector<double> stops = {start, end};
    for (const auto& history : system.s)
      for (const double t : breakpoints(history, duration))
        if (t > start && t < end) stops.push_back(t);
    std::sort(stops.begin(), stops.end());
    for (std::size_t s = 0; s + 1 < stops.size(); ++s) {
      const int n = 1 + static_cast<int>((stops[s + 1] - stops[s]) / 0.05);
      for (int i = 0; i < n; ++i) {
        const double h = (stops[s + 1] - stops[s]) / n;
        const States at = stepper->run(stops[s] + h * (i + rule.x.array()));
        means.u.col(j) += at.u * rule.w * (h / width);
        means.v.col(j) += at.v * rule.w * (h / width);
      }
    }
  }
  return means;
}

double distance(const States& a, const States& b) {
  return std::max((a.u - b.u).norm() / b.u.norm(), (a.v - b.v).norm() / b.v.norm());
}

// Under-, over- and undamped modes, rigid modes, every kind of load with its jumps inside windows.
std::vector<System> systems() {
  return {supported(all_exact_loads()),
          supported(all_exact_loads(), {}),
          supported(all_exact_loads(), {40, 0.5}),
          supported({}),
          free_chain(all_exact_loads()),
          free_chain({}, {}),
          diagonal(all_exact_loads())};
}

TEST(AveragesTest, MatchQuadratureOfTheRun) {
  for (const System& system : systems())
    for (const double width : {1e-3, 0.05, 0.4, 1.7}) {
      const VectorXd times = VectorXd::LinSpaced(23, 0, duration - width / 2);
      const States means = exact(system, duration)->averages(times, width);
      EXPECT_EQ(means.status, Status::ok);
      EXPECT_EQ(means.n_valid, times.size());
      EXPECT_LT(distance(means, quadrature(system, times, width)), 1e-12) << width;
    }
}

// Integrated, the equation of motion links both means with the velocities at the ends; no quadrature.
TEST(AveragesTest, SatisfyTheIntegratedEquationOfMotion) {
  for (const System& system : systems())
    for (const double width : {1e-2, 0.3, 2.0}) {
      const VectorXd times = VectorXd::LinSpaced(15, width / 2, duration - width / 2);
      const auto stepper = exact(system, duration);
      const States means = stepper->averages(times, width);
      const States start = stepper->run((times.array() - width / 2).max(0)),
                   end = stepper->run(times.array() + width / 2);
      System ramps = system;  // a unit mass without stiffness: its velocity is the impulse of the load
      ramps.M = MatrixXd::Identity(1, 1).sparseView();
      ramps.K.resize(1, 1);
      ramps.damping = {};
      ramps.R = MatrixXd::Identity(1, 1);
      ramps.u0 = ramps.v0 = VectorXd::Zero(1);
      MatrixXd impulse = MatrixXd::Zero(system.M.rows(), times.size());
      for (Index l = 0; l < system.F.cols(); ++l) {
        ramps.F = MatrixXd::Identity(1, 1);
        ramps.s = {system.s[static_cast<std::size_t>(l)]};
        const auto single = exact(ramps, duration);
        impulse += system.F.col(l) *
                   (single->run(times.array() + width / 2).v - single->run((times.array() - width / 2).max(0)).v);
      }
      for (Index j = 0; j < times.size(); ++j) {
        const VectorXd inertia = system.M * (end.v.col(j) - start.v.col(j)) / width;
        const VectorXd damping = apply_damping(system, means.v.col(j)), elastic = system.K * means.u.col(j);
        const double size = (system.M * end.v.col(j)).norm() / width + damping.norm() + elastic.norm();
        EXPECT_LT((inertia + damping + elastic - impulse.col(j) / width).norm(), 1e-12 * size);
        EXPECT_LT((means.v.col(j) - (end.u.col(j) - start.u.col(j)) / width).norm(),
                  1e-13 * end.u.col(j).norm() / width);
      }
    }
}

// Short windows: mean = value + w^2/24 second derivative, without loss of digits in the velocity.
TEST(AveragesTest, ShortWindowsKeepTheirDigits) {
  for (const System& system : {supported({Harmonic{3, 0.5}}), free_chain({Harmonic{3, 0.5}}), diagonal({Step{}})}) {
    const VectorXd times = VectorXd::LinSpaced(7, 0.3, 2.1);
    const auto stepper = exact(system, duration);
    const States values = stepper->run(times), means = stepper->averages(times, 1e-7);  // (omega w)^2/24 = 1e-14
    EXPECT_LT(distance(means, values), 1e-12);
  }
}

TEST(AveragesTest, UndampedResonance) {
  System system = diagonal({Harmonic{6, 0.3}, Harmonic{1, 1.1}});
  system.damping = {};
  for (const double width : {0.01, 0.9}) {
    const VectorXd times = VectorXd::LinSpaced(9, 0, 2.5);
    EXPECT_LT(distance(exact(system, duration)->averages(times, width), quadrature(system, times, width)), 1e-12);
  }
}

// Before t = 0 the body rests where it starts.
TEST(AveragesTest, WindowsBeginBeforeTheStart) {
  System system = free_chain({});
  const VectorXd origin = VectorXd::Zero(1);
  const double width = 1e-6;
  const States at_start = exact(system, duration)->averages(origin, width);
  EXPECT_LT((at_start.v.col(0) - system.v0 / 2).norm(), 1e-5 * system.v0.norm());  // moving for half of the window
  EXPECT_LT((at_start.u.col(0) - system.u0).norm(), width * system.v0.norm());
}

TEST(AveragesTest, EqualWindowsShareOneTransition) {  // windows inside a piece and single windows agree
  const System system = diagonal(all_exact_loads());
  const auto stepper = exact(system, duration);
  const VectorXd times = VectorXd::LinSpaced(201, 0, 2.9);
  const States together = stepper->averages(times, 0.1);
  States alone = together;
  for (Index j = 0; j < times.size(); ++j) {
    const States one = stepper->averages(times.segment(j, 1), 0.1);
    alone.u.col(j) = one.u, alone.v.col(j) = one.v;
  }
  EXPECT_LT(distance(together, alone), 1e-13);
}

TEST(AveragesTest, BadInput) {
  const System system = supported({Step{}});
  const auto stepper = exact(system, 1);
  const double nan = std::nan("");
  EXPECT_THROW(stepper->averages(Eigen::Vector2d(0, 0.96), 0.1), std::invalid_argument);  // reaches beyond
  EXPECT_NO_THROW(stepper->averages(Eigen::Vector2d(0, 0.95), 0.1));
  EXPECT_THROW(stepper->averages(Eigen::Vector2d(0.5, 0.4), 0.1), std::invalid_argument);
  EXPECT_THROW(stepper->averages(Eigen::Vector2d(-0.1, 0.4), 0.1), std::invalid_argument);
  EXPECT_THROW(stepper->averages(Eigen::Vector2d(0.1, nan), 0.1), std::invalid_argument);
  for (const double width : {0.0, -0.1, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(stepper->averages(Eigen::Vector2d(0, 0.4), width), std::invalid_argument);
  EXPECT_EQ(stepper->averages(VectorXd(), 0.1).u.cols(), 0);
  EXPECT_THROW(newmark(system, 0.1)->averages(Eigen::Vector2d(0.2, 0.4), 0.1),
               std::invalid_argument);  // no closed form
}

}  // namespace
}  // namespace mb
