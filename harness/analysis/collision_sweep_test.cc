#include "harness/analysis/collision_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/geometry/signed_distance.h"

namespace mb {
namespace {

std::vector<Shape> bodies() {
  return {Box{{1, 0.5, 2}}, Cylinder{0.4, 1.2}, Sphere{0.5}, Superquadric{{1, 2, 3}, 1, 0.5}};
}

TEST(CollisionSweep, PartnersAreOfTheBodysSize) {
  for (const Shape& body : bodies()) {
    EXPECT_DOUBLE_EQ(extent(sphere_of_size(body)), extent(body));
    EXPECT_DOUBLE_EQ(extent(superquadric_of_size(body)), extent(body));
    EXPECT_DOUBLE_EQ(2 * half_extents(body).maxCoeff(), extent(body));
  }
}

TEST(CollisionSweep, PointsOverlapByAsMuchAsAsked) {
  for (const Shape& body : bodies())
    for (const Shape& partner : {Shape(sphere_of_size(body)), Shape(superquadric_of_size(body))}) {
      const double overlap = 0.04 * half_extents(body).maxCoeff();
      const Matrix3Xd x = OverlappingPoints(body, partner, overlap).points(20000);
      const VectorXd d = distances_by_surface(partner, x).value;
      // Set by some 1000 polygons' middles: finer ones find deeper points, at sharp edges by a cell of a sixteenth.
      EXPECT_LT(d.minCoeff(), -0.9 * overlap);
      EXPECT_GT(d.minCoeff(), -4 * overlap);
      EXPECT_GT((d.array() > 0).count(), 15000);
      EXPECT_GT((d.array() < 0).count(), 0);
    }
}

TEST(CollisionSweep, AnyNumberOfPointsIsSpreadOverTheBody) {
  const OverlappingPoints all(Sphere{1}, Sphere{1}, 0.04);
  for (const Index m : {10, 100, 3333}) {
    const Matrix3Xd x = all.points(m);
    ASSERT_EQ(x.cols(), m);
    // The mean of points of a sphere is its centre: two radii over the partner's, less the overlap.
    const double tolerance = m < 100 ? 0.4 : 0.1;
    EXPECT_LT((x.rowwise().mean() - Vector3d(0, 0, 1.96)).norm(), tolerance);
  }
  EXPECT_THROW(all.points(0), std::invalid_argument);
  EXPECT_THROW(all.points(1'000'000), std::invalid_argument);
  EXPECT_THROW(OverlappingPoints(Sphere{1}, Sphere{1}, 0), std::invalid_argument);
  EXPECT_THROW(OverlappingPoints(Sphere{1}, Sphere{1}, std::nan("")), std::invalid_argument);
}

TEST(CollisionSweep, CrossoversAreWhereLinesCross) {
  const VectorXd x{{1, 10, 100, 1000}};
  const VectorXd square = x.array().square(), line = 30 * x;
  EXPECT_NEAR(crossover(x, line, square), 30, 1e-12);
  EXPECT_TRUE(std::isnan(crossover(x, square, line)));
  EXPECT_EQ(crossover(x, 0.01 * line, square), 1);  // at the smallest already
  EXPECT_TRUE(std::isnan(crossover(x, line, line)));
  const VectorXd once{{1, 1, 3, 1}}, two{{2, 2, 2, 2}};  // not for good before the last
  EXPECT_NEAR(crossover(x, once, two), 100 * std::pow(10, std::log(1.5) / std::log(3)), 1e-9);
  EXPECT_THROW(crossover(x, line.head(2), square), std::invalid_argument);
  EXPECT_THROW(crossover(x, 0 * line, square), std::invalid_argument);
  EXPECT_THROW(crossover(VectorXd(0), VectorXd(0), VectorXd(0)), std::invalid_argument);
}

}  // namespace
}  // namespace mb
