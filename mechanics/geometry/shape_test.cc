#include "mechanics/geometry/shape.h"

#include <gtest/gtest.h>

#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/patch.h"
#include "mechanics/geometry/tapered.h"

namespace mb {
namespace {

const std::vector<Shape> shapes = {Box{{0.3, 0.2, 0.7}}, Box{{1.2, 0.038, 0.089}}, Cylinder{0.05, 0.2}, Sphere{0.07},
                                   Superquadric{{0.3, 0.1, 0.2}, 0.4, 1.7}};

double surface_area(const Shape& shape) {
  if (const auto* b = std::get_if<Box>(&shape)) {
    const Vector3d& s = b->size;
    return 2 * (s[0] * s[1] + s[1] * s[2] + s[0] * s[2]);
  }
  if (const auto* c = std::get_if<Cylinder>(&shape)) return 2 * pi * c->radius * (c->radius + c->length);
  if (const auto* s = std::get_if<Superquadric>(&shape)) return surface_moments(*s).area;
  const double r = std::get<Sphere>(shape).radius;
  return 4 * pi * r * r;
}

double integral(const Quadrature& q, double (*f)(const Vector3d&)) {
  double sum = 0;
  for (Index i = 0; i < q.weights.size(); ++i) sum += q.weights[i] * f(q.points.col(i));
  return sum;
}

TEST(Quadrature, WeightsArePositiveAndSumToTheMeasure) {
  for (const Shape& shape : shapes) {
    const Quadrature inside = volume_quadrature(shape), on = surface_quadrature(shape);
    EXPECT_GT(inside.weights.minCoeff(), 0);
    EXPECT_GT(on.weights.minCoeff(), 0);
    EXPECT_NEAR(inside.weights.sum(), volume(shape), 1e-14 * volume(shape));
    EXPECT_NEAR(on.weights.sum(), surface_area(shape), 1e-13 * surface_area(shape));
    EXPECT_GT(inside.weights.size(), 200);
    EXPECT_LE(inside.weights.size(), 600);  // slender boxes: at least three points across
  }
}

TEST(Quadrature, PointsLieInsideAndOnTheSurface) {
  for (const Shape& shape : shapes) {
    const double tolerance = 1e-14 * extent(shape);
    const Quadrature inside = volume_quadrature(shape), on = surface_quadrature(shape);
    for (Index i = 0; i < inside.weights.size(); ++i) EXPECT_TRUE(contains(shape, inside.points.col(i), tolerance));
    for (Index i = 0; i < on.weights.size(); ++i) {
      double nearest = 1;
      for (const auto& face : face_names(shape))
        nearest = std::min(nearest, std::abs(face_distance(shape, face, on.points.col(i))));
      EXPECT_LT(nearest, tolerance);
    }
  }
}

TEST(Quadrature, IntegratesQuadraticsExactly) {
  const auto zz = [](const Vector3d& x) { return x[2] * x[2]; };
  const auto xy = [](const Vector3d& x) { return x[0] * x[1]; };
  for (const Shape& shape : shapes) {
    const Quadrature q = volume_quadrature(shape);
    const double scale = volume(shape) * extent(shape) * extent(shape);
    double moment = 0;
    if (const auto* b = std::get_if<Box>(&shape)) moment = b->size[2] * b->size[2] / 12;
    if (const auto* c = std::get_if<Cylinder>(&shape)) moment = c->length * c->length / 12;
    if (const auto* s = std::get_if<Sphere>(&shape)) moment = s->radius * s->radius / 5;
    if (const auto* s = std::get_if<Superquadric>(&shape)) moment = mb::moment(*s, 0, 0, 2) / volume(shape);
    // r^3 is no polynomial's measure for r^2: the ball's radial Gauss rule leaves 1e-4 of it.
    const double tolerance = std::holds_alternative<Sphere>(shape) ? 1e-3 : 1e-13;
    EXPECT_NEAR(integral(q, zz), volume(shape) * moment, tolerance * scale);
    EXPECT_NEAR(integral(q, xy), 0, 1e-15 * scale);
  }
}

TEST(Gauss, IsExactToDegreeTwoNMinusOne) {
  for (int n = 1; n <= 40; ++n) {
    const Rule rule = gauss_legendre(n);
    EXPECT_NEAR(rule.w.sum(), 1, 1e-14);
    const int degree = 2 * n - 1;
    EXPECT_NEAR(rule.w.dot(rule.x.array().pow(degree).matrix()), 1.0 / (degree + 1), 1e-14);
  }
  EXPECT_THROW(gauss_legendre(0), std::invalid_argument);
}

TEST(Faces, NormalsPointOutAndCurvedOnesAreRefused) {
  EXPECT_EQ(plane_normal(Box{{1, 2, 3}}, "y-min"), Vector3d(0, -1, 0));
  EXPECT_EQ(plane_normal(Cylinder{1, 2}, "z-max"), Vector3d(0, 0, 1));
  EXPECT_THROW(plane_normal(Cylinder{1, 2}, "side"), std::invalid_argument);
  EXPECT_THROW(plane_normal(Cylinder{1, 2}, "x-max"), std::invalid_argument);
  EXPECT_DOUBLE_EQ(face_distance(Cylinder{1, 2}, "z-min", {0, 0, -3}), 2);
  EXPECT_DOUBLE_EQ(face_distance(Sphere{2}, "surface", {0, 1, 0}), -1);
}

TEST(Faces, ASuperquadricHasOneCurvedFace) {
  const Shape octahedron = Superquadric{{1, 2, 3}, 2, 2};
  EXPECT_EQ(face_names(octahedron), std::vector<std::string>{"surface"});
  EXPECT_FALSE(is_plane(octahedron, "surface"));
  EXPECT_THROW(plane_normal(octahedron, "surface"), std::invalid_argument);
  EXPECT_THROW(face_distance(octahedron, "side", {0, 0, 0}), std::invalid_argument);
  EXPECT_DOUBLE_EQ(extent(octahedron), 6);
  EXPECT_NEAR(face_distance(octahedron, "surface", {0, 0, -4}), 1, 1e-15);
  EXPECT_NEAR(face_distance(octahedron, "surface", {0, 0, 0}), -6.0 / 7, 1e-15);  // of x + y/2 + z/3 = 1
  EXPECT_TRUE(contains(octahedron, {0.3, 0.6, -0.9}, 0));
  EXPECT_FALSE(contains(octahedron, {0, 0, -3.1}, 0.09));
  EXPECT_TRUE(contains(octahedron, {0, 0, -3.1}, 0.11));
}

TEST(Patch, WeightIsOneAtTheCentreAndVanishesSmoothlyAtTheRim) {
  const Patch patch{"z-max", Disc{{0.1, 0, 0.5}, 0.2}};
  EXPECT_DOUBLE_EQ(weight(patch, {0.1, 0, 0.5}), 1);
  EXPECT_DOUBLE_EQ(weight(patch, {0.1, 0.2, 0.5}), 0);
  EXPECT_DOUBLE_EQ(weight(patch, {0.1, 0.1, 0.5}), 0.5625);
  EXPECT_LT(weight(patch, {0.1, 0.199, 0.5}), 1e-3);
  EXPECT_DOUBLE_EQ(weight({"z-max", {}}, {9, 9, 9}), 1);
}

}  // namespace
}  // namespace mb
