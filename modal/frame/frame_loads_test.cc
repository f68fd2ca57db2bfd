#include "modal/frame/frame_loads.h"

#include <gtest/gtest.h>

#include "modal/frame/body_flight.h"
#include "modal/frame/particles_test.h"

namespace mb {
namespace {

// Five particles under a load that turns with them and one that does not, each of some force and torque.
struct Loaded {
  Particles particles = five_particles();
  System system;

  Loaded() {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    system.F = MatrixXd(15, 2);
    for (double& f : system.F.reshaped()) f = 20 * normal(random);
    system.s = {Harmonic{9, 0.4}, Pulse{0.5, 1, 0.1001}};
    system.follows = {true, false};
    particles.body.loads =
        std::make_shared<const FrameLoads>(frame_loads(system, particles.X.reshaped(), particles.Phi, 1));
  }
  Matrix3Xd acceleration(const Matrix3Xd& x, double t) const {
    const Index n = x.cols();
    const Matrix3Xd turning = system.F.col(0).reshaped(3, n) * value(system.s[0], t),
                    steady = system.F.col(1).reshaped(3, n) * value(system.s[1], t);
    const Matrix3Xd force = particles.frame(x) * turning + steady;
    return particles.acceleration(x) + Matrix3Xd(force * particles.mass.cwiseInverse().asDiagonal());
  }
};

// Against Runge-Kutta's steps of the particles in the world's axes, which know of no frame.
TEST(FrameLoads, MoveParticlesAsInTheWorld) {
  const Loaded loaded;
  const Particles& p = loaded.particles;
  const BodyState start = tumbling(p.body, 0.03);
  Matrix3Xd x = p.places(start), v = p.velocities(start);
  const double T = 1, h = 5e-4;  // as for the free motion: error (2 pi h/T)^4 = 2e-6 of a part of q
  for (int i = 0; i < 2000; ++i) {
    const double t = i * h;
    const Matrix3Xd a1 = loaded.acceleration(x, t), v2 = v + h / 2 * a1,
                    a2 = loaded.acceleration(x + h / 2 * v, t + h / 2), v3 = v + h / 2 * a2,
                    a3 = loaded.acceleration(x + h / 2 * v2, t + h / 2), v4 = v + h * a3,
                    a4 = loaded.acceleration(x + h * v3, t + h);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  const BodyState end = BodyFlight(p.body, start, 0).at(T);
  EXPECT_LT(((p.places(end).colwise() + end.c) - x).norm(), 4e-6 * x.norm());
  EXPECT_LT(((p.velocities(end).colwise() + end.v) - v).norm(), 4e-5 * v.norm());
  // Neither load is a small matter.
  for (const bool turning : {true, false}) {
    Loaded other;
    other.system.follows = {turning, turning};
    other.particles.body.loads =
        std::make_shared<const FrameLoads>(frame_loads(other.system, p.X.reshaped(), p.Phi, 1));
    const BodyState astray = BodyFlight(other.particles.body, start, 0).at(T);
    EXPECT_GT(((p.places(astray).colwise() + astray.c) - x).norm(), 0.02 * x.norm());
  }
}

// What is asked for in between does not depend on what was asked before; c and L are what force and torque bring.
TEST(FrameLoads, PushARigidBody) {
  Particles p = five_particles();
  p.body.modes.clear();
  p.body.coupling = nullptr;
  p.Phi.resize(15, 0);
  System system;
  system.F = Vector3d(2, -3, 5).replicate(5, 1);
  for (Index k = 0; k < 5; ++k) system.F.middleRows(3 * k, 3) *= p.mass[k] / p.mass.sum();  // no torque
  system.s = {Step{1, 0.25}};
  p.body.loads = std::make_shared<const FrameLoads>(frame_loads(system, p.X.reshaped(), p.Phi, 1));
  BodyState start = tumbling(p.body, 0);
  start.v = {1, 2, 3};
  const BodyFlight flight(p.body, start, 0);
  FloatingBody unloaded = p.body;
  unloaded.loads = nullptr;
  const BodyFlight alone(unloaded, start, 0);
  for (const double t : {1.0, 0.2, 0.25, 0.6}) {
    const double since = std::max(0.0, t - 0.25);
    const Vector3d c = t * start.v + since * since / 2 * Vector3d(2, -3, 5) / p.mass.sum();
    const BodyState at = flight.at(t);
    EXPECT_LT((at.c - c).norm(), 1e-12 * c.norm()) << t;
    EXPECT_LT((at.L - start.L).norm(), 1e-12 * start.L.norm()) << t;
    EXPECT_LT(at.Q.angularDistance(alone.at(t).Q), 1e-7) << t;  // steps of 1e-9 against the closed form
  }
}

TEST(FrameLoads, SeeJumpsFromTheLeft) {
  Particles p = five_particles();
  System system;
  system.F = VectorXd::Ones(15);
  system.s = {Step{1, 0.25}};
  system.follows = {true};
  const FrameLoads loads = frame_loads(system, p.X.reshaped(), p.Phi, 1);
  const Eigen::Quaterniond Q(1, 0, 0, 0);
  EXPECT_EQ(loads.amplitudes(0.25, 0.2, Q)[0], 0);
  EXPECT_EQ(loads.amplitudes(0.25, 0.25, Q)[0], 1);
  EXPECT_EQ(loads.next_jump(0), 0.25);
  EXPECT_EQ(loads.next_jump(0.25), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace mb
