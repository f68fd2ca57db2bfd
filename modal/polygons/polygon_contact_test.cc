// Brute force, tree and analytic distances of the same points from the same bodies.
#include "modal/polygons/polygon_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "mechanics/geometry/signed_distance.h"
#include "mechanics/geometry/superquadric.h"
#include "modal/polygons/tree.h"

namespace mb {
namespace {

const Superquadric quartic{{0.5, 0.4, 0.3}, 0.5, 0.5};

std::vector<Shape> shapes() {
  return {Box{{1, 0.8, 0.6}}, Cylinder{0.4, 1.2}, Sphere{0.5}, quartic, Superquadric{{0.3, 0.5, 0.4}, 2, 1}};
}

// Points in general position, and those in which several features are nearest: vertices, middles of edges and faces,
// the centre, points straight over vertices.
Matrix3Xd points_about(const Polygons& polygons) {
  std::srand(7);
  const TriangleMesh& mesh = polygons.mesh();
  const Index n_v = mesh.vertices.cols(), n_t = std::min<Index>(polygons.size(), 100);
  Matrix3Xd points(3, 300 + 2 * n_v + 2 * n_t + 1);
  points.leftCols(300) = 2 * polygons.extent() * Matrix3Xd::Random(3, 300);
  points.middleCols(300, n_v) = mesh.vertices;
  points.middleCols(300 + n_v, n_v) = 1.25 * mesh.vertices;
  for (Index i = 0; i < n_t; ++i) {
    const Vector3d a = mesh.vertices.col(mesh.triangles(0, i)), b = mesh.vertices.col(mesh.triangles(1, i)),
                   c = mesh.vertices.col(mesh.triangles(2, i));
    points.col(300 + 2 * n_v + 2 * i) = (a + b) / 2;
    points.col(300 + 2 * n_v + 2 * i + 1) = (a + b + c) / 3;
  }
  points.rightCols(1).setZero();
  return points;
}

TEST(PolygonContact, TreeAndBruteForceAgreeToTheBit) {
  for (const Shape& shape : shapes()) {
    const Polygons polygons(triangulate(shape, 5));
    const Matrix3Xd points = points_about(polygons);
    const PointDistances all = distances_by_brute_force(polygons, points);
    const PointDistances few = PolygonTree(polygons).distances(points);
    EXPECT_EQ(all.value, few.value) << shape.index();
    EXPECT_EQ(all.n_triangles, polygons.size() * points.cols());
    EXPECT_LT(few.n_tests(), all.n_tests() / 2);
  }
}

// Inscribed in a convex body, polygons are inside it: farther away from every point outside, nearer to one inside.
TEST(PolygonContactVerification, PolygonsApproachTheExactDistanceWithTheSquareOfTheirSize) {
  for (const Shape& shape : {shapes()[2], shapes()[3]}) {
    std::srand(1);
    const Matrix3Xd points = 0.7 * Matrix3Xd::Random(3, 400);
    const VectorXd exact = distances_by_surface(shape, points).value;
    double before = 0;
    for (const int n : {8, 16, 32}) {
      const VectorXd error = distances_by_brute_force(Polygons(triangulate(shape, n)), points).value - exact;
      EXPECT_GE(error.minCoeff(), -1e-14);
      if (before > 0) {
        EXPECT_NEAR(std::log2(before / error.mean()), 2, 0.15);  // h^2 and part of h^4
      }
      before = error.mean();
    }
  }
}

// On a box the polygons are the surface.
TEST(PolygonContactVerification, PolygonsOfABoxAreExact) {
  const Box box{{1, 0.8, 0.6}};
  const Polygons polygons(triangulate(box, 3));
  const Matrix3Xd points = points_about(polygons);
  const VectorXd difference =
      distances_by_brute_force(polygons, points).value - distances_by_surface(box, points).value;
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-15);  // rounding of coordinates of 1
}

// Sharp vertices: the nearest point of most points outside is a tip, where only the weighted normal has the right sign.
TEST(PolygonContact, SignsAreThoseOfTheInsideOutsideFunction) {
  const Superquadric octahedron{{0.9, 0.7, 0.8}, 2, 2};  // polygons are exact here, too
  const Polygons polygons(triangulate(octahedron, 1));
  std::srand(3);
  const Matrix3Xd points = Matrix3Xd::Random(3, 3000);
  const VectorXd d = distances_by_brute_force(polygons, points).value;
  int n_inside = 0;
  for (Index j = 0; j < points.cols(); ++j) {
    const double N = gauge(octahedron, points.col(j));
    if (std::abs(N - 1) < 1e-12) continue;
    EXPECT_EQ(d[j] < 0, N < 1);
    n_inside += N < 1;
  }
  EXPECT_GT(n_inside, 100);  // 8 % of the cube
}

TEST(PolygonContact, TheFunctionHasTheRightSignAndIsExactInTheLimitOnTheSurface) {
  std::srand(2);
  const Matrix3Xd points = 0.6 * Matrix3Xd::Random(3, 500);
  const VectorXd exact = distances_by_surface(quartic, points).value;
  const VectorXd estimate = distances_by_function(quartic, points).value;
  for (Index j = 0; j < points.cols(); ++j) EXPECT_EQ(exact[j] < 0, estimate[j] < 0);
  // Along a normal: d, but for a part of second order.
  const Vector3d y = Vector3d(0.3, 0.2, 0.15) / gauge(quartic, Vector3d(0.3, 0.2, 0.15));
  const Vector3d n = outward_normal(quartic, y);
  double before = 0;
  for (const double d : {0.02, 0.01, 0.005}) {
    const double error = std::abs(distances_by_function(quartic, y + d * n).value[0] - d);
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / error), 2, 0.2);
    }
    before = error;
  }
  EXPECT_EQ(distances_by_function(quartic, Vector3d(0, 0, 0)).value[0], -0.3);
  EXPECT_EQ(distances_by_function(quartic, points).n_functions, 500);
}

// On the surface boxes visited grow like the logarithm of the number of triangles, from afar like its root: all of
// them would be 4 times as many from one mesh to the next.
TEST(PolygonContact, ATreeTestsFewBoxesAPoint) {
  std::srand(4);
  const Matrix3Xd far = Matrix3Xd::Random(3, 200);
  Matrix3Xd on = far;
  for (auto x : on.colwise()) x /= gauge(quartic, x);
  double from_afar = 0, on_surface = 0;
  for (const int n : {4, 8, 16, 32}) {
    const Polygons polygons(triangulate(quartic, n));
    const PolygonTree tree(polygons);
    const double of_far = static_cast<double>(tree.distances(far).n_tests()) / 200;
    const double of_on = static_cast<double>(tree.distances(on).n_tests()) / 200;
    EXPECT_GT(of_on, std::log2(static_cast<double>(polygons.size())));
    if (n > 4) {
      EXPECT_LT(of_far, 2.2 * from_afar);
      EXPECT_LT(of_on, 1.35 * on_surface);  // log n grows by less than a third
    }
    from_afar = of_far;
    on_surface = of_on;
    EXPECT_GT(tree.bytes(), polygons.size() * 64);  // a box and two children each
  }
}

TEST(PolygonContact, SearchesWithinADistanceFindWhatIsThereAndCostLess) {
  const Polygons polygons(triangulate(quartic, 6));
  const PolygonTree tree(polygons);
  const Matrix3Xd points = points_about(polygons);
  const PointDistances all = tree.distances(points);
  for (const double within : {0.0, 0.05, 0.4}) {
    const PointDistances near = tree.distances(points, within);
    EXPECT_LT(near.n_tests(), all.n_tests());
    for (Index j = 0; j < points.cols(); ++j)
      EXPECT_EQ(near.value[j],
                std::abs(all.value[j]) <= within ? all.value[j] : std::numeric_limits<double>::infinity());
  }
  EXPECT_THROW(tree.distances(points, -1), std::invalid_argument);
  EXPECT_THROW(tree.distances(points, std::nan("")), std::invalid_argument);
}

TEST(PolygonContact, DepthsInsideAreTheDistancesThere) {
  std::srand(5);
  const Matrix3Xd points = 0.6 * Matrix3Xd::Random(3, 500);
  for (const Shape& shape : shapes()) {
    const VectorXd exact = distances_by_surface(shape, points).value;
    const PointDistances inside = depths_inside(shape, points);
    for (Index j = 0; j < points.cols(); ++j)
      EXPECT_EQ(inside.value[j], exact[j] < 0 ? exact[j] : std::numeric_limits<double>::infinity());
    EXPECT_GE(inside.n_functions, (exact.array() < 0).count());
    EXPECT_LE(inside.n_functions, 500 + (exact.array() < 0).count());
  }
}

TEST(PolygonContact, BadMeshesAndPointsAreRefused) {
  const TriangleMesh good = triangulate(Sphere{1}, 2);
  const auto refused = [&](auto&& spoil) {
    TriangleMesh mesh = good;
    spoil(mesh);
    EXPECT_THROW(Polygons{mesh}, std::invalid_argument);
  };
  refused([](TriangleMesh& m) { m.triangles.conservativeResize(3, m.triangles.cols() - 1); });  // a hole
  refused([](TriangleMesh& m) { m.triangles.col(1) = m.triangles.col(0); });
  refused([](TriangleMesh& m) { std::swap(m.triangles(0, 3), m.triangles(1, 3)); });  // inside out
  refused([](TriangleMesh& m) { m.triangles(0, 0) = static_cast<int>(m.vertices.cols()); });
  refused([](TriangleMesh& m) { m.triangles(0, 0) = -1; });
  refused([](TriangleMesh& m) { m.triangles(0, 0) = m.triangles(1, 0); });  // no area
  refused([](TriangleMesh& m) { m.vertices(1, 1) = std::numeric_limits<double>::quiet_NaN(); });
  refused([](TriangleMesh& m) { m.triangles.resize(3, 0); });
  const Polygons polygons(good);
  const PolygonTree tree(polygons);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Vector3d x(0, bad, 0);
    EXPECT_THROW(distances_by_brute_force(polygons, x), std::invalid_argument);
    EXPECT_THROW(tree.distances(x), std::invalid_argument);
    EXPECT_THROW(distances_by_surface(Sphere{1}, x), std::invalid_argument);
    EXPECT_THROW(distances_by_function(quartic, x), std::invalid_argument);
    EXPECT_THROW(depths_inside(quartic, x), std::invalid_argument);
  }
  EXPECT_THROW(distances_by_surface(Sphere{-1}, Vector3d(1, 0, 0)), std::invalid_argument);
  EXPECT_EQ(tree.distances(Matrix3Xd(3, 0)).value.size(), 0);
}

}  // namespace
}  // namespace mb
