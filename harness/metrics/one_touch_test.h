// For tests of metrics in contact: a body that touches once, its answer by hand, and marks of that.
#pragma once

#include <gtest/gtest.h>

#include "cases/scene/one_body.h"
#include "harness/metrics/metric.h"

namespace mb::one_touch {

// A block of 0.1 x 0.2 x 0.3 m and 1000 kg/m^3, 6 kg, that falls at 2 m/s under a weight of 10 m/s^2. Times: 0, 0.1,
// ..., 0.4 s. Points: eight corners of a cube about the centre, one of the surface.
struct Setting {
  Scene scene = one_body(Box{{0.1, 0.2, 0.3}}, {1e6, 0.3, 1000, {}}, {1, {1, 1, 1}});
  EvaluationPoints points;
  MetricContext context(bool free = true) const { return {scene, 0, points, free}; }
};
inline constexpr double m = 6;  // [kg]

inline Setting setting() {
  Setting s;
  s.scene.bodies[0].twist.velocity = {0, 0, -2};
  s.scene.gravity = {0, 0, -10};
  s.points.volume = {Matrix3Xd(3, 8), VectorXd::Constant(8, 0.006 / 8)};
  for (int i = 0; i < 8; ++i)
    s.points.volume.points.col(i) = 0.02 * Vector3d(i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1);
  s.points.surface = {Vector3d(0, 0, 0.15), VectorXd::Ones(1)};
  s.points.probes = Matrix3Xd(3, 0);
  return s;
}

// One touch from 0.1 to 0.3 s, of peak 90 N and impulse 18 N s upwards, and histories by hand.
inline Trajectory answer(const Setting& s) {
  Trajectory t{VectorXd::LinSpaced(5, 0, 0.4), {}, {}, Status::ok};
  BodyTrajectory body;
  body.displacement = MatrixXd::Zero(3 * s.points.size(), 5);
  body.strain = MatrixXd(0, 0);
  ContactHistory& c = body.contact;
  c.force = Matrix3Xd::Zero(3, 5);
  c.force.row(2) << 0, 0, 90, 0, 0;
  c.impulse = Matrix3Xd::Zero(3, 5);
  c.impulse.row(2) << 0, 0, 9, 18, 18;
  c.stored = VectorXd{{0, 0, 4, 0, 0}};
  c.dissipated = VectorXd{{0, 0, 1, 3, 3}};
  c.touches = {{0.1, 0.3, 90, 0.2, {0, 0, 18}}};
  body.energy = VectorXd{{100, 100, 99, 97, 97}};
  t.bodies.push_back(body);
  return t;
}
inline ContactHistory& contact(Trajectory& t) { return t.bodies[0].contact; }

inline Mark marked(const std::string& name, const Trajectory& a, const Trajectory& b, const MetricContext& context) {
  return mark(metric(name), a, b, context);
}
inline double value(const std::string& name, const Trajectory& a, const Trajectory& b, const MetricContext& context) {
  const Mark of = marked(name, a, b, context);
  EXPECT_EQ(of.status, "ok") << name;
  return of.value;
}

}  // namespace mb::one_touch
