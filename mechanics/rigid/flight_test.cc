#include "mechanics/rigid/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "mechanics/verified_test.h"

namespace mb {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;

const Vector3d gravity(0.3, -0.2, -9.81);
const Pose pose0{{1, 2, 3}, Quaterniond(AngleAxisd(0.8, Vector3d(1, 2, 2) / 3))};
const Twist twist0{{4, -1, 6}, {3, -5, 2}};

// Not centred, no axis along the body's.
MassProperties lopsided() {
  const Matrix3d R = AngleAxisd(0.6, Vector3d(2, -1, 2) / 3).toRotationMatrix();
  return {2.5, {0.1, -0.2, 0.05}, R * Vector3d(0.02, 0.05, 0.06).asDiagonal() * R.transpose()};
}

TEST(Flight, StartsFromItsData) {
  const Flight flight(lopsided(), pose0, twist0, gravity);
  EXPECT_LE((flight.at(0).position - pose0.position).norm(), 1e-15);
  EXPECT_LE(flight.at(0).orientation.angularDistance(pose0.orientation), 1e-15);
  EXPECT_LE((flight.twist_at(0).velocity - twist0.velocity).norm(), 1e-14);
  EXPECT_LE((flight.twist_at(0).angular_velocity - twist0.angular_velocity).norm(), 1e-14);
}

TEST(Flight, CentroidFallsAlongAParabola) {
  const MassProperties body = lopsided();
  const Flight flight(body, pose0, twist0, gravity);
  const Vector3d c0 = pose0.to_world(body.centroid);
  const Vector3d v0 = twist0.velocity + twist0.angular_velocity.cross(c0 - pose0.position);
  for (const double t : {-1.0, 0.3, 5.0}) {  // to 130 m from the origin, where a rounding is 3e-14 m
    const Vector3d c = c0 + v0 * t + 0.5 * t * t * gravity;
    EXPECT_LE((flight.centroid_at(t) - c).norm(), 1e-12);
    EXPECT_LE((flight.at(t).to_world(body.centroid) - c).norm(), 1e-12);
    const Twist twist = flight.twist_at(t);
    const Vector3d v = twist.velocity + twist.angular_velocity.cross(c - flight.at(t).position);
    EXPECT_LE((v - v0 - t * gravity).norm(), 1e-12);
  }
}

// Central differences: error of the second order, h^2/6 |x'''| and rounding, some 1e-9 here.
TEST(FlightVerification, TwistIsTheRateOfThePose) {
  const Flight flight(lopsided(), pose0, twist0, gravity);
  const double h = 1e-5;
  for (double t = -1; t < 2; t += 0.17) {
    const Pose before = flight.at(t - h), after = flight.at(t + h);
    const Twist twist = flight.twist_at(t);
    EXPECT_LE(((after.position - before.position) / (2 * h) - twist.velocity).norm(), 1e-7);
    const AngleAxisd turn(after.orientation * before.orientation.conjugate());
    EXPECT_LE((turn.angle() / (2 * h) * turn.axis() - twist.angular_velocity).norm(), 1e-7);
  }
}

// Angular momentum about the centroid and kinetic energy of the rotation, in world axes, whatever the body's axes.
TEST(FlightVerification, KeepsMomentumAndEnergy) {
  const MassProperties body = lopsided();
  const Flight flight(body, pose0, twist0, gravity);
  const auto momentum = [&](double t) -> Vector3d {
    const Quaterniond q = flight.at(t).orientation;
    return q * (body.inertia * (q.conjugate() * flight.twist_at(t).angular_velocity));
  };
  const Vector3d L = momentum(0);
  double worst = 0;
  for (const double t : {0.1, 3.0, 1e3, 1e6}) {
    EXPECT_LE((momentum(t) - L).norm(), 1e-13 * L.norm());
    worst = std::max((momentum(t) - L).norm() / L.norm(), worst);
    EXPECT_NEAR(momentum(t).dot(flight.twist_at(t).angular_velocity), L.dot(twist0.angular_velocity), 1e-12);
  }
  testing::expect_verified(
      {.quantity = "angular momentum of a lopsided body about its centroid after up to 1e6 s, relative in norm",
       .reference = "property",
       .source = "Conservation of angular momentum without torque",
       .uncertainty = "rounding",
       .tolerance = 1e-13,
       .why = "One closed form gives orientation and spin: some roundings of turns are left, whatever the time."},
      worst);
}

TEST(Flight, OfAShapeTurnsAboutItsOrigin) {
  const Flight flight(mass_properties(Cylinder{0.02, 0.3}, 900), pose0, twist0, gravity);
  EXPECT_LE((flight.at(0.7).position - (pose0.position + 0.7 * twist0.velocity + 0.245 * gravity)).norm(), 1e-14);
}

TEST(Flight, BoundsSpeedsOfItsPoints) {
  std::mt19937 generator(2);
  std::normal_distribution<double> normal;
  const MassProperties body = lopsided();
  for (int i = 0; i < 50; ++i) {
    const Twist twist{{normal(generator), normal(generator), 5 * normal(generator)},
                      {normal(generator), 9 * normal(generator), normal(generator)}};
    const Flight flight(body, pose0, twist, gravity);
    const double r = 0.3, t0 = normal(generator), t1 = t0 + normal(generator), bound = flight.speed_bound(r, t0, t1);
    EXPECT_EQ(bound, flight.speed_bound(r, t1, t0));
    double fastest = 0;
    for (int n = 0; n <= 200; ++n) {
      const double t = t0 + (t1 - t0) * n / 200;
      const Twist now = flight.twist_at(t);
      for (int k = 0; k < 20; ++k) {
        const Vector3d arm = r * Vector3d(normal(generator), normal(generator), normal(generator)).normalized();
        fastest = std::max(fastest, (flight.centroid_velocity_at(t) + now.angular_velocity.cross(arm)).norm());
      }
    }
    EXPECT_LE(fastest, bound);
    EXPECT_GE(fastest, 0.3 * bound);  // of use: no bound of orders of magnitude
  }
}

TEST(Flight, BoundIsReached) {
  const Flight falling(mass_properties(Sphere{0.1}, 1), {}, {}, {0, 0, -10});
  EXPECT_NEAR(falling.speed_bound(0.1, -1, 2), 20, 1e-12);  // no spin
  const Flight spinning(mass_properties(Sphere{0.1}, 1), {}, {{3, 0, 0}, {0, 0, 4}}, Vector3d::Zero());
  EXPECT_NEAR(spinning.speed_bound(0.1, 0, 9), 3.4, 1e-12);
}

TEST(Flight, RefusesWhatIsNoMotion) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const MassProperties body = lopsided();
  for (const double x : {nan, inf}) {
    const Vector3d bad(0, x, 0);
    EXPECT_THROW(Flight(body, {bad, Quaterniond::Identity()}, {}, gravity), std::invalid_argument);
    EXPECT_THROW(Flight(body, {Vector3d::Zero(), Quaterniond(1, x, 0, 0)}, {}, gravity), std::invalid_argument);
    EXPECT_THROW(Flight(body, {}, {bad, Vector3d::Zero()}, gravity), std::invalid_argument);
    EXPECT_THROW(Flight(body, {}, {Vector3d::Zero(), bad}, gravity), std::invalid_argument);
    EXPECT_THROW(Flight(body, {}, {}, bad), std::invalid_argument);
    EXPECT_THROW(Flight({1, bad, body.inertia}, {}, {}, gravity), std::invalid_argument);
    EXPECT_THROW(Flight({1, Vector3d::Zero(), x * body.inertia}, {}, {}, gravity), std::invalid_argument);
    const Flight flight(body, pose0, twist0, gravity);
    EXPECT_THROW(flight.speed_bound(x, 0, 1), std::invalid_argument);
    EXPECT_THROW(flight.speed_bound(1, x, 1), std::invalid_argument);
    EXPECT_THROW(flight.speed_bound(1, 0, x), std::invalid_argument);
    EXPECT_THROW(flight.at(x), std::invalid_argument);
    EXPECT_THROW(flight.twist_at(x), std::invalid_argument);
  }
  EXPECT_THROW(Flight(body, {}, {}, gravity).speed_bound(-1, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace mb
