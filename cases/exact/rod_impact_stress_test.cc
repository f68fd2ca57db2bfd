// The stress at the face of a rod that runs on to a wall: rho c v while it touches (Graff 1975, Wave Motion in Elastic
// Solids, sect. 2.4), but for the layer's rise and fall. Marked by its mean over 0.1 to 0.9 of the contact.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/exact/exact.h"
#include "cases/exact/rod_impact.h"
#include "cases/scene/one_body.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr double L = 0.1, E = 1e7, rho = 1000, v = 0.1;  // of cases/rod-on-wall.toml: c = 100 m/s
const double c = std::sqrt(E / rho), hard = rho * c * v;

// With Y = 2 k_n L/E it is at 0.1 T short of rho c v by e^-Y/10, and at 0.9 T it has not begun to fall while 0.9 T <
// 2 L/c, which is Y > 15: the mean lacks (e^-y_1 - e^-y_2)/(y_2 - y_1), y_1 and y_2 being Y T/tau times 0.1 and 0.9.
TEST(RodImpactStressVerification, MeanIsThatOfAHardWall) {
  for (const double layers : {20.0, 50.0, 100.0, 1e4}) {
    const RodImpactWaves waves({L, E, rho, v, layers * E / L});
    const double T = waves.contact().duration, from = 0.1 * T, to = 0.9 * T, Y = 2 * layers;
    const double mean = (waves.impulse(to) - waves.impulse(from)) / (to - from);
    EXPECT_NEAR(mean, hard, 0.01 * hard) << layers;
    const double y1 = 0.1 * (Y + 1.678347), y2 = 9 * y1;
    EXPECT_NEAR(1 - mean / hard, (std::exp(-y1) - std::exp(-y2)) / (y2 - y1), 1e-9) << layers;
  }
}

// The same of the case's answer: strain at the middle of the face, force on the face, samples of the scene.
TEST(RodImpactStressVerification, MeanAtTheMiddleOfTheFaceIsThatOfAHardWall) {
  const double edge = 0.01, A = edge * edge;
  Scene scene = one_body(Box{Vector3d(edge, edge, L)}, {E, 0, rho, {}}, {1, {1, 1, 200}});
  scene.bodies[0].pose.position = {0, 0, L / 2 + 2e-4};
  scene.bodies[0].twist.velocity = {0, 0, -v};
  scene.obstacles.push_back({"wall", {HalfSpace{}, 0, {}}});
  scene.contacts.push_back({.body = "body", .obstacle = "wall", .stiffness = 100 * E / L});
  scene.probes = {{"middle", "body", Vector3d(0, 0, -L / 2), Vector3d::UnitZ()}};
  scene.duration = 0.006;
  scene.samples_per_second = scene.frame_rate = 64000;
  const Trajectory said =
      exact_solution("rod-on-wall").at(scene, evaluation_points(scene, scene.bodies[0]), sample_times(scene));
  const BodyTrajectory& body = said.bodies.at(0);
  ASSERT_EQ(body.contact.touches.size(), 1u);
  const double start = body.contact.touches[0].start, T = body.contact.touches[0].end - start;
  EXPECT_NEAR(T, 2 * L / c, 0.01 * 2 * L / c);  // 1.678/200
  double stress = 0, force = 0;
  int n = 0;
  for (Index k = 0; k < said.t.size(); ++k) {
    if (said.t[k] < start + 0.1 * T || said.t[k] > start + 0.9 * T) continue;
    stress -= E * body.strain(body.strain.rows() - 4, k);  // zz of the last point, compression positive
    force += body.contact.force(2, k);
    ++n;
  }
  ASSERT_GT(n, 100);
  // All samples lie between the rise and the fall: e^-20 from rho c v at the first.
  testing::expect_verified(
      {.quantity =
           "stress at the middle of the face of a rod on a wall, and force over the face's area, means over 0.1 "
           "to 0.9 of the contact, relative",
       .reference = "exact solution",
       .source = "rho c v of a hard wall (Graff 1975, sect. 2.4)",
       .uncertainty = "2e-9, the layer's e^-20 at the first sample",
       .tolerance = 1e-8,
       .why =
           "All samples lie between the rise and the fall of the pressure, where the layer takes e^-20 of it or less."},
      Eigen::Vector2d(stress / n / hard - 1, force / n / A / hard - 1).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

}  // namespace
}  // namespace mb
