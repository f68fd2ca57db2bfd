#include "modal/contact/contact_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "mechanics/contact/hertz.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/verified_test.h"
#include "modal/bases/eigenmodes.h"
#include "reference/full_model.h"

namespace mb {
namespace {

constexpr double R = 0.05;

// A ball that comes down on a floor so fast that Hertz's contact has a fifth of its radius, on a mesh fine there.
struct Setting {
  explicit Setting(int graded, double height = 1e-3) {
    Scene s = one_body(Sphere{R}, {1e6, 0.3, 1000, {}}, {2, {1}, graded});
    s.bodies[0].pose.position = {0, 0, R + height};
    const double k = 4.0 / 3 * 1e6 / 0.91 * std::sqrt(R), m = 1000 * 4 / 3.0 * pi * R * R * R;
    s.bodies[0].twist.velocity = {0, 0, -std::sqrt(0.8 * k * std::pow(0.04 * R, 2.5) / m)};
    s.obstacles.push_back({"floor", {HalfSpace{}, 0, {}}});
    s.contacts.push_back({.body = s.bodies[0].name, .obstacle = "floor", .stiffness = 0});
    scene = std::make_shared<const Scene>(s);
    model = build_model(scene);
    down = touchdown(*scene, scene->bodies[0]);
  }
  const System& system() const { return model.bodies[0].full->system(); }
  double shift() const { return physical_shift(scene->bodies[0]); }
  MatrixXd shapes(const Modes& modes) const {
    return contact_shapes(*scene, scene->bodies[0], model.bodies[0], modes, shift());
  }

  std::shared_ptr<const Scene> scene;
  Model model;
  Touchdown down;
};

TEST(ContactShapes, AreStiffnessOrthonormalAndOrthogonalToTheModes) {
  const Setting ball(2);
  const System& s = ball.system();
  for (const int r : {0, 12}) {
    const Modes modes = lowest_modes(s, r, ball.shift());
    const MatrixXd Psi = ball.shapes(modes);
    ASSERT_GE(Psi.cols(), 2);
    ASSERT_LE(Psi.cols(), 9);
    const MatrixXd K = Psi.transpose() * (s.K * Psi);
    EXPECT_LT((K - MatrixXd::Identity(Psi.cols(), Psi.cols())).cwiseAbs().maxCoeff(), 1e-6);
    // Rigid modes and elastic: of both mass and stiffness; by M Psi's own size.
    const MatrixXd M_Psi = s.M * Psi;
    const VectorXd size = (Psi.transpose() * M_Psi).diagonal().cwiseSqrt();
    const MatrixXd across = modes.Phi.transpose() * M_Psi * size.cwiseInverse().asDiagonal();
    EXPECT_LT(across.cwiseAbs().maxCoeff(), 1e-6) << r;
  }
}

void verify_differences(double worst) {
  testing::expect_verified(
      {.quantity =
           "approach of a ball by its static shapes, with 20 modes and none, under Hertz's pressure on discs of 0.1, "
           "0.2 and 0.4 R, differences from disc to disc, relative, the worst",
       .reference = "published",
       .source = "Johnson 1985, Contact Mechanics, sect. 3.4: 3 P/(4 E* b) of a half-space",
       .uncertainty = "1.3e-2, a sphere's logarithm of b (cases/exact/sphere_series.h), and terms of order (b/R)^2",
       .tolerance = 0.06,
       .why = "What a sphere is beyond a half-space does not all cancel from disc to disc, 1.3 % by its logarithm; "
              "the rest is room for (b/R)^2, 4 % at the middle disc, and the mesh."},
      worst);
}

// Hertz's pressure on a disc b of a half-space: u(0) = pi p_0 b / (2 E*), 3 P/(4 E* b) under the force P (Johnson 1985,
// sect. 3.4). From disc to disc under the same force what the ball as a whole does cancels to order (b/R)^2.
TEST(ContactShapesVerification, TogetherWithTheModesAreBoussinesqs) {
  const Setting ball(4);
  const FullModel& full = *ball.model.bodies[0].full;
  const Meeting& meeting = ball.down.meetings[0];
  const double a = meeting.size.radius, E = 1e6 / 0.91;
  ASSERT_NEAR(a, 0.2 * R, 1e-3 * R);
  const MatrixXd at = full.displacement_at(meeting.X);
  const double expected = 3 / (8 * E * a);  // of a against 2 a; twice that of a/2 against a
  double worst = 0;
  for (const int r : {0, 20}) {
    const Modes modes = lowest_modes(ball.system(), r, ball.shift());
    const MatrixXd Psi = ball.shapes(modes);
    const Index n = modes.size() - modes.n_rigid;
    const auto Phi = modes.Phi.rightCols(n);
    const auto approach = [&](double b) {  // under a force of 1 N
      const GradedRule rule = graded_rule(Sphere{R}, {meeting.X}, {b / 8, b / 4, 1, 3}, b);
      VectorXd p = VectorXd::Zero(3 * rule.weights.size());
      for (Index i = 0; i < rule.weights.size(); ++i)
        p[3 * i + 2] =
            rule.weights[i] * std::sqrt(std::max(0.0, 1 - (rule.points.col(i) - meeting.X).squaredNorm() / b / b));
      const double force = p.sum();
      EXPECT_NEAR(force, 2 * pi * b * b / 3, 0.03 * force);
      const VectorXd F = full.displacement_at(rule.points).transpose() * p / force;
      const VectorXd lambda = modes.omega.tail(n).array().square();
      const VectorXd u = Psi * (Psi.transpose() * F) + Phi * (Phi.transpose() * F).cwiseQuotient(lambda);
      return (at * u)[2];
    };
    const double wide = approach(2 * a), middle = approach(a), narrow = approach(a / 2);
    EXPECT_NEAR(middle - wide, expected, 0.06 * expected) << r;
    EXPECT_NEAR(narrow - middle, 2 * expected, 0.06 * 2 * expected) << r;
    EXPECT_NEAR(middle, 2 * expected, 0.3 * 2 * expected) << r;
    worst = std::max({worst, std::abs((middle - wide) / expected - 1), std::abs((narrow - middle) / expected / 2 - 1)});
  }
  verify_differences(worst);
}

// Modes that have all of it leave nothing; what never touches needs nothing.
TEST(ContactShapes, AreNoneWhereNothingIsMissing) {
  const Setting whole(0);
  const Index n = whole.system().M.rows();
  const Modes all = lowest_modes(whole.system(), static_cast<int>(n) - 6, whole.shift());
  ASSERT_EQ(all.size(), n);
  EXPECT_EQ(whole.shapes(all).cols(), 0);
  const Setting far(0, 100);
  EXPECT_EQ(far.shapes(lowest_modes(far.system(), 4, far.shift())).cols(), 0);
  EXPECT_EQ(far.shapes(lowest_modes(far.system(), 4, far.shift())).rows(), n);
}

}  // namespace
}  // namespace mb
