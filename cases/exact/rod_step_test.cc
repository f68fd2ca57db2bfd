#include "cases/exact/rod_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/exact/exact_test_scenes.h"
#include "cases/exact/exact_test_table.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/system/oscillator.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using testing::expect_verified;

constexpr RodStep unit_held{1, 1, 1, 1, true}, unit_free{1, 1, 1, 1, false};

// Columns: t, held u(1), held u(.5), ..., free u(loaded), free u(far), v likewise. Written with ten digits, but held
// u(.5), a series that was cut at 1e-8, at the corners of the motion at 5.2e-7.
TEST(RodStepVerification, Table) {
  const auto table = numbers("rod_step_load.csv");
  ASSERT_EQ(table.size(), 81u);
  double worst = 0;
  for (const auto& row : table) {
    const double t = row[0];
    const double u = rod_state(unit_held, 1, t).u;
    EXPECT_NEAR(u, row[1], 1e-9);
    worst = worse(worst, std::abs(u - row[1]));
    const bool corner = std::abs(std::remainder(t - 0.5, 1)) < 1e-6;
    EXPECT_NEAR(rod_state(unit_held, 0.5, t).u, row[2], corner ? 5.2e-7 : 1e-8);
    EXPECT_NEAR(rod_state(unit_free, 1, t).u, row[5], 1e-9);
    EXPECT_NEAR(rod_state(unit_free, 0, t).u, row[6], 1e-9);
    const double h = 1e-4;  // velocities are constant between fronts; the table gives those behind a front
    EXPECT_NEAR((rod_state(unit_free, 1, t + 2 * h).u - rod_state(unit_free, 1, t + h).u) / h, row[7], 1e-9);
    EXPECT_NEAR((rod_state(unit_free, 0, t + 2 * h).u - rod_state(unit_free, 0, t + h).u) / h, row[8], 1e-9);
  }
  expect_verified({.quantity = "displacement of a held rod's loaded end after a step of load, over its static one",
                   .reference = "table",
                   .source = "d'Alembert's waves (Graff 1975, sect. 2.3) in another program: rod_step_load.csv",
                   .uncertainty = "1e-10, the table's digits",
                   .tolerance = 1e-9,
                   .why = "Ten digits after the point, 5e-11, of values up to 2: twenty times their rounding."},
                  worst);
}

// The table's truncated series, by the oscillators of mechanics/: modes sin((n - 1/2) pi x) and cos(n pi x).
TEST(RodStepVerification, ModalSeriesOfTheTable) {
  const auto series = [](const RodStep& rod, int n_modes, double t) {
    double u = rod.is_held ? 0 : t * t / 2;
    for (int n = 1; n <= n_modes; ++n) {
      const double omega = (rod.is_held ? n - 0.5 : n) * pi;
      u += 2 * response(roots({omega * omega, 0}), t).P;
    }
    return u;
  };
  const auto table = numbers("rod_step_load.csv");
  ASSERT_EQ(table.size(), 81u);
  MatrixXd off(4, 81);
  for (Index j = 0; j < off.cols(); ++j) {
    const auto& row = table[static_cast<std::size_t>(j)];
    off.col(j) << series(unit_held, 8, row[0]) - row[3], series(unit_held, 32, row[0]) - row[4],
        series(unit_free, 8, row[0]) - row[9], series(unit_free, 32, row[0]) - row[10];
    for (const RodStep& rod : {unit_held, unit_free})  // the tail of sum 2/omega^2: 2/(pi^2 N)
      EXPECT_NEAR(series(rod, 3000, row[0]), rod_state(rod, 1, row[0]).u, 2 * 2.01 / (pi * pi * 3000));
  }
  expect_verified({.quantity = "displacement of the loaded end of a held and a free rod after a step of load, by 8 and "
                               "32 modes, over the held one's static displacement",
                   .reference = "table",
                   .source = "the same modes in another program: rod_step_load.csv",
                   .uncertainty = "1e-12, the table's digits",
                   .tolerance = 1e-11,
                   .why = "Twelve digits after the point of values up to 32, and the rounding of either sum."},
                  off.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

const RodStep held{1.7, 3e9, 1200, 6e5, true}, released{1.7, 3e9, 1200, 6e5, false};

// u'' = u_tt/c^2 by differences that stay between fronts; strain is du/dx; ends as stated.
TEST(RodStepTest, SatisfiesTheWaveEquationAndItsEnds) {
  for (const RodStep& rod : {held, released}) {
    const double c = std::sqrt(rod.youngs_modulus / rod.density), scale = rod.traction / rod.youngs_modulus;
    for (const double t : {3.3e-4, 1.07e-3, 2.5e-3, 0.0317})
      for (const double x : {0.21, 0.84, 1.52}) {
        const auto u = [&](double dx, double dt) { return rod_state(rod, x + dx, t + dt).u; };
        const double h = 1e-3, dt = h / c;  // rounding of u/h^2: 1e-15 x 30 / 1e-6
        const double u_xx = (u(h, 0) - 2 * u(0, 0) + u(-h, 0)) / (h * h);
        const double u_tt = (u(0, dt) - 2 * u(0, 0) + u(0, -dt)) / (dt * dt);
        EXPECT_NEAR(u_tt / (c * c), u_xx, 1e-6 * scale);
        EXPECT_NEAR((u(h, 0) - u(-h, 0)) / (2 * h), rod_state(rod, x, t).strain, 1e-9 * scale);
      }
    for (const double t : {3.3e-4, 1.07e-3, 0.0317}) {
      EXPECT_NEAR(rod_state(rod, rod.length, t).strain, scale, 1e-15 * scale);
      if (rod.is_held)
        EXPECT_NEAR(rod_state(rod, 0, t).u, 0, 1e-13 * scale);
      else
        EXPECT_NEAR(rod_state(rod, 0, t).strain, 0, 1e-15 * scale);
    }
    EXPECT_EQ(rod_state(rod, 1, -1e-9).u, 0);
    EXPECT_EQ(rod_state(rod, 1, -1e-9).strain, 0);
  }
}

// Momentum of the free rod grows by the impulse, whatever the waves do.
TEST(RodStepTest, FreeRodGainsTheImpulse) {
  const double mass = released.density * released.length;
  for (const double t : {2e-4, 3.1e-3, 0.7}) {
    double mean = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) mean += rod_state(released, released.length * (i + 0.5) / n, t).u / n;
    const double expected = released.traction / mass * t * t / 2;
    EXPECT_NEAR(mean, expected, 1e-8 * expected);  // kinks within the midpoint rule: 1/n^2
  }
}

TEST(RodStepTest, AnswersAtThePointsOfAScene) {
  for (const bool is_held : {false, true})
    for (const double sign : {1.0, -1.0}) {
      const std::string face = sign > 0 ? "z-max" : "z-min", other = sign > 0 ? "z-min" : "z-max";
      Scene scene =
          rod_scene(face, is_held ? std::vector{support(Support::Kind::sliding, other)} : std::vector<Support>{});
      const EvaluationPoints points = evaluation_points(scene, scene.bodies[0]);
      const VectorXd t = sample_times(scene);
      const Trajectory answer = exact_solution("rod-step").at(scene, points, t);
      ASSERT_EQ(answer.bodies.size(), 1u);
      const MatrixXd &displacement = answer.bodies[0].displacement, &strain = answer.bodies[0].strain;
      ASSERT_EQ(displacement.rows(), 3 * points.size());
      ASSERT_EQ(strain.rows(), 6 * points.n_strained());
      // pulled along +z: outward at z-max, inward at z-min
      const RodStep rod{1.7, 3e9, 1200, sign * 6e5, is_held};
      const Matrix3Xd all = points.all();
      for (Index j = 0; j < t.size(); j += 7)
        for (Index p = 0; p < points.size(); p += 13) {
          const RodState state = rod_state(rod, 0.85 + sign * all(2, p), t[j] - 1e-4);
          EXPECT_EQ(displacement(3 * p + 2, j), sign * state.u);
          EXPECT_EQ(displacement.block(3 * p, j, 2, 1).norm(), 0);
          const Index e = points.strained(p);
          if (e < 0) continue;
          EXPECT_EQ(strain(6 * e + 2, j), state.strain);
          EXPECT_EQ(strain.block(6 * e, j, 6, 1).norm(), std::abs(state.strain));
        }
      scene.loads[0].tractions[0] = {"body", {face, std::nullopt}, Vector3d::Zero(), -sign * 4e5};  // as a pressure
      EXPECT_EQ(exact_solution("rod-step").at(scene, points, t).bodies[0].displacement, displacement);
    }
}

}  // namespace
}  // namespace mb
