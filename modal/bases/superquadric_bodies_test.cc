// Free bodies whose boundary is a superquadric: nothing closed is known but of balls, so that meshes speak for each
// other.
#include <gtest/gtest.h>

#include "modal/bases/verification_test.h"

namespace mb {
namespace {

using testing::frequency_errors;
using testing::levels;
using testing::order;
using testing::radius;
using testing::steel;

constexpr int n_modes = 12;

VectorXd frequencies(const Shape& shape, const Resolution& resolution) {  // [rad/s]
  return VectorXd::Ones(n_modes) +
         frequency_errors(one_body(shape, steel, resolution), 6, std::vector<double>(n_modes, 1), 1, n_modes);
}

// By another door than a sphere's: Lamb's spectrum, as free_bodies_test.cc has it of the sphere.
TEST(SuperquadricVerification, OfABallHasLambsFrequencies) {
  const auto expected = levels("sphere_exact_nu0.3.csv", 5, [](const auto& row) { return static_cast<int>(row[4]); });
  const auto errors = [&](const Shape& shape) {
    return frequency_errors(one_body(shape, steel, {2, {2}}), 6, expected, radius / shear_wave_speed(steel), 20);
  };
  const VectorXd ball = errors(Superquadric{Vector3d::Constant(radius), 1, 1}), sphere = errors(Sphere{radius});
  EXPECT_LT(ball.maxCoeff(), 2e-2);
  EXPECT_LT((ball - sphere).cwiseAbs().maxCoeff(), 1e-9);  // the same nodes: of the eigensolver
}

// Quadratics of order 4, mode by mode 3.4 to 4.7 on these coarse meshes; what Richardson's rule makes of them meets
// quartics on an eighth of their cells six times closer than the finest does itself.
TEST(SuperquadricVerification, FrequenciesConverge) {
  for (const Shape& shape : {Shape(Superquadric{{0.1, 0.075, 0.105}, 1, 1}),
                             Shape(TaperedSuperquadric{{{0.0958, 0.0718, 0.1104}, 1, 1}, 0.4})}) {
    const VectorXd middle = frequencies(shape, {2, {2}}), fine = frequencies(shape, {2, {4}}),
                   quartic = frequencies(shape, {4, {2}});
    const VectorXd limit = fine - (middle - fine) / 15, orders = order(middle - quartic, fine - quartic);
    EXPECT_GT((fine - quartic).minCoeff(), 0);  // Ritz's bounds
    EXPECT_GT(orders.minCoeff(), 3.2) << orders.transpose();
    EXPECT_NEAR(orders.mean(), 4, 0.2) << orders.transpose();
    EXPECT_LT((limit.cwiseQuotient(quartic).array() - 1).abs().maxCoeff(), 2.5e-4);
    EXPECT_LT((fine.cwiseQuotient(quartic).array() - 1).abs().maxCoeff(), 1.5e-3);
  }
}

}  // namespace
}  // namespace mb
