#include "mechanics/rigid/torque_free.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "mechanics/rigid/random_test_body.h"

namespace mb {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

TEST(TorqueFree, StartsFromItsData) {
  std::mt19937 generator(1);
  for (int i = 0; i < 400; ++i) {
    const auto [I, w, q, t] = random_body(generator, i % 8);
    EXPECT_LE(difference({q, w}, TorqueFree(I, q, w).at(0)), 8 * eps) << i;
  }
}

// To rounding whatever the time: 1e6 revolutions cost phase, never energy or momentum.
TEST(TorqueFree, KeepsEnergyMomentumAndUnitLength) {
  std::mt19937 generator(2);
  for (int i = 0; i < 4000; ++i) {
    const auto [I, w, q, duration] = random_body(generator, i % 8);
    const Vector3d L = q * I.cwiseProduct(w);
    for (const double t : {0.1 * duration, duration, 1e3 * duration, 1e5 * duration}) {
      const Rotation r = TorqueFree(I, q, w).at(t);
      EXPECT_NEAR(r.orientation.norm(), 1, 2 * eps);
      EXPECT_NEAR(I.dot(r.angular_velocity.cwiseAbs2()) / I.dot(w.cwiseAbs2()), 1, 16 * eps) << i;
      EXPECT_LE((r.orientation * I.cwiseProduct(r.angular_velocity) - L).norm(), 16 * eps * L.norm()) << i;
    }
  }
}

TEST(TorqueFree, ComposesFromIntervals) {
  std::mt19937 generator(3);
  for (int i = 0; i < 400; ++i) {
    const auto [I, w, q, t] = random_body(generator, i % 8);
    const TorqueFree body(I, q, w);
    const Rotation half_way = body.at(0.4 * t);
    const TorqueFree later(I, half_way.orientation, half_way.angular_velocity);
    // Twice: compilers may fuse products, and the state half way is rounded as well.
    const double bar =
        2 * (rounding(body, I, q, w, t) + rounding(later, I, half_way.orientation, half_way.angular_velocity, 0.6 * t));
    EXPECT_LE(difference(body.at(t), later.at(0.6 * t)), bar) << i;
    EXPECT_LE(difference({q, w}, later.at(-0.4 * t)), bar) << i;  // and back
  }
}

// Moments off by 1e-10 change rates by some of that, whichever branch the limit takes: two or three equal moments.
TEST(TorqueFree, IsContinuousWhereMomentsMeet) {
  std::mt19937 generator(4);
  std::normal_distribution<double> normal;
  for (const Vector3d& I : {Vector3d(1, 1, 1), Vector3d(1, 1, 1.7), Vector3d(2, 0.3, 2), Vector3d(1, 1.3, 1.3)})
    for (int i = 0; i < 100; ++i) {
      const Vector3d w(normal(generator), normal(generator), normal(generator));
      const Quaterniond q(AngleAxisd(normal(generator), Vector3d::UnitX()));
      const double t = 30 * normal(generator);
      const TorqueFree limit(I, q, w);
      for (const double off : {1e-10, 1e-13, 4e-16}) {
        const Vector3d change(off * normal(generator), off * normal(generator), off * normal(generator));
        const double ratio = I.maxCoeff() / I.minCoeff(), phase = 1 + limit.max_angular_speed() * std::abs(t);
        EXPECT_LE(difference(limit.at(t), TorqueFree(I + change, q, w).at(t)),
                  4 * (4 * off + eps) * ratio * phase * phase);
      }
    }
}

// Towards spin about each principal axis, where components of w' at most 1e-150 |w|^2 count as none. About the
// intermediate one a push grows as exp(lambda t), here to e^3.
TEST(TorqueFree, IsContinuousTowardsSteadySpin) {
  const Vector3d I(1, 2, 2.5);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d w = 3 * Vector3d::Unit(axis), aside = Vector3d::Ones() - Vector3d::Unit(axis);
    const TorqueFree limit(I, Quaterniond::Identity(), w);
    for (const double push : {1e-6, 1e-10, 1e-16, 1e-80, 1e-149, 1e-151, 1e-200})
      for (const double t : {0.4, -1.0, 3.0})
        EXPECT_LE(difference(limit.at(t), TorqueFree(I, Quaterniond::Identity(), w + push * aside).at(t)),
                  push * std::exp(3 * std::abs(t)) + 16 * eps);
  }
}

TEST(TorqueFree, SpinsSteadilyAboutPrincipalAxes) {
  const Quaterniond q(AngleAxisd(0.7, Vector3d(2, -1, 2) / 3));
  for (const Vector3d& I : {Vector3d(1, 2, 2.5), Vector3d(3, 3, 3), Vector3d(1e-9, 1, 1)})
    for (int axis = 0; axis < 3; ++axis)
      for (const double speed : {-2.0, 1e-300, 1e150}) {
        const double t = 1.3 / std::abs(speed);
        const Rotation r = TorqueFree(I, q, speed * Vector3d::Unit(axis)).at(t);
        EXPECT_EQ(r.angular_velocity, Vector3d(speed * Vector3d::Unit(axis)));
        const Rotation exact{q * AngleAxisd(speed * t, Vector3d::Unit(axis)), r.angular_velocity};
        EXPECT_LE(difference({exact.orientation, Vector3d::UnitX()}, {r.orientation, Vector3d::UnitX()}), 8 * eps);
      }
}

TEST(TorqueFree, RestsWithoutSpin) {
  const Quaterniond q(AngleAxisd(0.7, Vector3d(2, -1, 2) / 3));
  const TorqueFree body({1, 2, 2.5}, q, Vector3d::Zero());
  EXPECT_EQ(body.max_angular_speed(), 0);
  for (const double t : {0.0, 1e30, -1e300}) {
    EXPECT_LE(body.at(t).orientation.angularDistance(q), 4 * eps);
    EXPECT_EQ(body.at(t).angular_velocity, Vector3d(Vector3d::Zero()));
  }
}

// Speeds of any size are the same motion at another pace.
TEST(TorqueFree, ScalesWithTime) {
  const Vector3d I(1, 2, 2.5), w(0.3, -1, 0.4);
  const Rotation r = TorqueFree(I, Quaterniond::Identity(), w).at(7);
  for (const double pace : {1e-290, 1e-3, 1e8, 1e290}) {
    Rotation scaled = TorqueFree(I, Quaterniond::Identity(), pace * w).at(7 / pace);
    scaled.angular_velocity /= pace;
    EXPECT_LE(difference(r, scaled), 1e-13) << pace;
    EXPECT_LE(difference(r, TorqueFree(1e3 / pace * I, Quaterniond::Identity(), w).at(7)), 1e-13) << pace;
  }
}

TEST(TorqueFree, BoundsItsSpeedTightly) {
  std::mt19937 generator(5);
  for (int i = 0; i < 200; ++i) {
    const auto [I, w, q, duration] = random_body(generator, 6);
    const TorqueFree body(I, q, w);
    double fastest = 0;
    for (int n = 0; n < 4000; ++n) fastest = std::max(fastest, body.at(0.02 * n / w.norm()).angular_velocity.norm());
    EXPECT_LE(fastest, body.max_angular_speed());
    EXPECT_GE(fastest, 0.99 * body.max_angular_speed()) << i;  // samples 0.02 apart, some 10 or more revolutions
  }
}

TEST(TorqueFree, RefusesWhatIsNoBody) {
  const Quaterniond q = Quaterniond::Identity();
  for (const Vector3d& I : {Vector3d(0, 1, 1), Vector3d(-1, 1, 1), Vector3d(nan, 1, 1), Vector3d(1, inf, inf),
                            Vector3d(1, 1, 2.0001), Vector3d(1e-101, 1, 1), Vector3d(inf, 1, 1)})
    EXPECT_THROW(TorqueFree(I, q, {1, 2, 3}), std::invalid_argument) << I.transpose();
  EXPECT_NO_THROW(TorqueFree({1, 1, 2}, q, {1, 2, 3}));  // flat
  for (const double x : {nan, inf}) {
    EXPECT_THROW(TorqueFree({1, 2, 2.5}, q, {1, x, 0}), std::invalid_argument);
    EXPECT_THROW(TorqueFree({1, 2, 2.5}, Quaterniond(1, x, 0, 0), {1, 1, 0}), std::invalid_argument);
    EXPECT_THROW(TorqueFree({1, 2, 2.5}, q, {1, 1, 0}).at(x), std::invalid_argument);
  }
  EXPECT_THROW(TorqueFree({1, 2, 2.5}, Quaterniond(1, 0.1, 0, 0), {1, 1, 0}), std::invalid_argument);
  EXPECT_THROW(TorqueFree({1, 2, 2.5}, q, {1, 1, 0}).at(1e305), std::invalid_argument);
}

}  // namespace
}  // namespace mb
