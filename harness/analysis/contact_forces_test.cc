// The contest of contact forces: contenders against each other, and what must hold between the numbers of its tables.
#include "harness/analysis/contact_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "harness/analysis/power_law.h"

namespace mb {
namespace {

const Superquadric quartic{{0.5, 0.4, 0.3}, 0.5, 0.5};
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(ContactContest, DirectionsAreEvenlySpread) {
  const Matrix3Xd d = directions(200);
  EXPECT_LT((d.colwise().norm().array() - 1).abs().maxCoeff(), 1e-15);
  // Second moments of a uniform density: 1/3 of the identity, first ones 0.
  EXPECT_LT((d * d.transpose() / 200 - Eigen::Matrix3d::Identity() / 3).cwiseAbs().maxCoeff(), 0.005);
  EXPECT_LT(d.rowwise().mean().norm(), 0.005);
  EXPECT_EQ(directions(1).cols(), 1);
  EXPECT_THROW(directions(0), std::invalid_argument);
}

// All weights are areas: they add up to that of the surface, of the polygons to less, of all alike to the same.
TEST(ContactContest, WeightsAreAreas) {
  const double area = surface_quadrature(quartic).weights.sum();
  EXPECT_NEAR(uniform_quadrature(quartic, 12).weights.sum(), area, 2e-3 * area);  // h^2
  const double polygons = vertices_by_areas(quartic, 12).weights.sum();
  EXPECT_LT(polygons, area);
  EXPECT_NEAR(polygons, area, 1e-2 * area);
  EXPECT_NEAR(vertices_by_equal(quartic, 12).weights.sum(), polygons, 1e-12 * polygons);
  for (const int bad : {0, -1, 201}) {
    EXPECT_THROW(vertices_by_areas(quartic, bad), std::invalid_argument);
    EXPECT_THROW(uniform_quadrature(quartic, bad), std::invalid_argument);
  }
}

TEST(ContactContest, PointsOfTheRegionAreWhereContactIs) {
  const Matrix3Xd down = directions(5);
  for (Index i = 0; i < down.cols(); ++i) {
    const PressedBody body = pressed_body(quartic, down.col(i), 0.01);
    for (const Index n : {24, 200, 1000}) {
      const SurfacePoints samples = region_quadrature(body, n);
      EXPECT_LE(samples.weights.size(), n);
      EXPECT_GE(errors_of_samples(body, samples).depth, 0);
      // Enough to cover the cap, and n large: most of the points are in or next to it.
      EXPECT_GT(samples.weights.sum(), n < 200 ? 0 : body.cap.contact.area * 0.99);
      if (n == 1000) {
        EXPECT_LT(samples.weights.sum(), 6 * body.cap.contact.area);
      }
    }
  }
  EXPECT_THROW(region_quadrature(pressed_body(quartic, down.col(0), 0.01), 3), std::invalid_argument);
}

// Samples of any kind tend to the exact cap; those in the region fastest.
TEST(ContactContestVerification, SamplesTendToTheExactForceAndImpact) {
  const Matrix3Xd down = directions(6);
  VectorXd few = VectorXd::Zero(3), many = VectorXd::Zero(3);
  for (Index i = 0; i < down.cols(); ++i) {
    const PressedBody body = pressed_body(quartic, down.col(i), 0.03);
    const auto add = [&](VectorXd& sum, int k) {
      sum[0] += errors_of_samples(body, vertices_by_areas(quartic, k)).force;
      sum[1] += errors_of_samples(body, uniform_quadrature(quartic, k)).impulse;
      sum[2] += errors_of_samples(body, region_quadrature(body, 24 * k * k)).force;
    };
    add(few, 4);
    add(many, 32);
  }
  // h^2 for smooth kinks, 64 times less at best; a third of it asked for, of sums over few orientations.
  EXPECT_LT(many[0], few[0] / 20);
  EXPECT_LT(many[1], few[1] / 20);
  EXPECT_LT(many[2], few[2] / 10);
  EXPECT_LT(many[2], many[0] / 5);
}

// On a sphere the closed form is exact; on an ellipsoid it is in the limit.
TEST(ContactContestVerification, CurvaturesAreExactOnASphereAndOfFirstOrderElsewhere) {
  const ContactErrors of_sphere = errors_of_curvatures(pressed_body(Sphere{0.3}, Vector3d(1, 2, 3), 0.05));
  for (const double error : as_vector(of_sphere)) EXPECT_LT(error, 1e-9);  // time to rest by quadrature
  const Superquadric ellipsoid{{0.5, 0.4, 0.3}, 1, 1};
  double before = 0;
  for (const double depth : {0.02, 0.01, 0.005}) {
    const ContactErrors errors = errors_of_curvatures(pressed_body(ellipsoid, Vector3d(1, 2, 3), depth));
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / errors.area), 1, 0.1);
    }
    before = errors.area;
    EXPECT_TRUE(std::isnan(errors.hertz));
    EXPECT_EQ(errors.depth, 0);
  }
}

TEST(ContactForces, TablesAreWholeAndMeansBelowTheWorst) {
  const ContactSizes sizes{{0.05}, {4, 8, 16}, 6};
  for (const Shape& body : {Shape(Box{{1, 1, 2}}), Shape(quartic)}) {
    const std::vector<Finding> all = contact_forces(body, sizes);
    ASSERT_EQ(all.size(), 3u);
    const size_t n_shapes = std::holds_alternative<Superquadric>(body) ? 1 : 2;
    EXPECT_EQ(all[0].rows.size(), n_shapes * (3 * 4 + 1));
    for (const Finding& table : all) {
      EXPECT_EQ(table.analysis, "contact-forces");
      for (const auto& row : table.rows) ASSERT_EQ(row.size(), table.columns.size()) << table.name;
    }
    for (const auto& row : all[0].rows)
      for (size_t j = 5; j < row.size(); j += 2) {
        const double mean = std::get<double>(row[j]), worst = std::get<double>(row[j + 1]);
        EXPECT_TRUE(std::isnan(mean) ? std::isnan(worst) : mean <= worst * (1 + 1e-12)) << all[0].columns[j].name;
      }
    for (size_t i = 0; i < all[0].rows.size(); ++i)
      for (size_t j = 5; j < all[0].columns.size(); ++j)
        EXPECT_EQ(all[0].bars[i][j] > 0, std::isfinite(std::get<double>(all[0].rows[i][j]))) << all[0].columns[j].name;
    for (size_t i = 0; i < all[2].rows.size(); ++i) {
      const auto& row = all[2].rows[i];
      EXPECT_EQ(std::get<std::string>(row[0]), "C12");
      EXPECT_GE(std::get<double>(row[2]), std::get<double>(row[3]));
      for (const size_t j : {2, 3})
        EXPECT_EQ(all[2].bars[i][j] > 0, std::isfinite(std::get<double>(row[j]))) << all[2].columns[j].name;
    }
  }
}

TEST(ContactForces, VerdictsFollowFromGains) {
  EXPECT_EQ(contact_verdict({1.1, infinite}), "holds");
  EXPECT_EQ(contact_verdict({1.1, 1.0, 0.2}),
            "holds within limits: more accurate at 1 of 3 depths and numbers of samples");
  EXPECT_EQ(contact_verdict({0.9, 0}), "does not hold: more accurate at 0 of 2 depths and numbers of samples");
  EXPECT_EQ(contact_verdict({}), "not decided: nothing to compare");
}

}  // namespace
}  // namespace mb
