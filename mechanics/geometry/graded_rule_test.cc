#include "mechanics/geometry/graded_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/tapered.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const std::vector<Shape> shapes = {Box{{0.3, 0.2, 0.7}},
                                   Box{{1.2, 0.038, 0.089}},
                                   Cylinder{0.05, 0.2},
                                   Sphere{0.07},
                                   Superquadric{{0.3, 0.1, 0.2}, 1, 1},
                                   Superquadric{{0.3, 0.1, 0.2}, 0.4, 1.5},
                                   Superquadric{{0.1, 0.1, 0.3}, 0.1, 0.1},
                                   Superquadric{{0.2, 0.1, 0.1}, 2, 2},
                                   TaperedSuperquadric{{{0.1, 0.08, 0.12}, 0.8, 0.8}, 0.6}};

// The surface point on the ray through d, from the shapes' definitions.
Vector3d on_surface(const Shape& shape, const Vector3d& d) {
  if (const auto* tapered = std::get_if<TaperedSuperquadric>(&shape))
    return Taper(*tapered).apply(on_surface(tapered->straight, d));
  const double level = std::visit(
      overloaded{
          [&](const Box& b) { return 2 * d.cwiseQuotient(b.size).cwiseAbs().maxCoeff(); },
          [&](const Cylinder& c) { return std::max(d.head<2>().norm() / c.radius, 2 * std::abs(d[2]) / c.length); },
          [&](const Sphere& s) { return d.norm() / s.radius; }, [&](const Superquadric& q) { return gauge(q, d); },
          [](const TaperedSuperquadric&) { return 0.0; }},
      shape);
  return d / level;
}

std::vector<Vector3d> random_surface_points(const Shape& shape, int n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Vector3d> points(n);
  for (Vector3d& x : points) x = on_surface(shape, {normal(random), normal(random), normal(random)});
  return points;
}

// The least of |x - x_i| - radius_i: not above 0 where a sample covers x.
double uncovered(const GradedRule& rule, const Vector3d& x) {
  return ((rule.points.colwise() - x).colwise().norm().transpose() - rule.radius).minCoeff();
}

double nearest(const std::vector<Vector3d>& foci, const Vector3d& x) {
  double d = infinity;
  for (const Vector3d& focus : foci) d = std::min(d, (focus - x).norm());
  return d;
}

// Pairwise, so that the error shown is the rule's: 1e5 weights one after the other round to 1e-13 of their sum.
double sum(const VectorXd& w) {
  const Index half = w.size() / 2;
  return half < 8 ? w.sum() : sum(w.head(half)) + sum(w.tail(w.size() - half));
}

double area(const Shape& shape, double coarsest, int n) {
  return sum(graded_rule(shape, {}, {coarsest, coarsest, 0, n}).weights);
}

TEST(GradedRuleVerification, AreasOfPlaneFacesAndCylindersSidesAreExact) {
  const Vector3d s(0.3, 0.2, 0.7);
  const double box = 2 * (s[0] * s[1] + s[1] * s[2] + s[0] * s[2]);
  for (const int n : {1, 2, 3, 7, 16})
    EXPECT_NEAR(sum(graded_rule(Box{s}, {{0.1, 0.1, 0.35}}, {1e-3, 0.2, 0.5, n}).weights), box, 1e-14 * box);
  const GradedRule can = graded_rule(Cylinder{0.05, 0.2}, {{0.05, 0, 0}}, {1e-3, 0.1, 0.5, 1});
  double side = 0;
  for (Index i = 0; i < can.weights.size(); ++i)
    if (std::abs(can.normals(2, i)) < 0.5) side += can.weights[i];
  EXPECT_NEAR(side, 2 * pi * 0.05 * 0.2, 1e-14);
}

// Order 2n, over two halvings: which cells are cut when varies a little. On the can only the ends have an error.
TEST(GradedRuleVerification, AreasConvergeWithOrderTwiceThePoints) {
  const double R = 0.07, L = 0.2;
  const std::vector<std::pair<Shape, double>> exact = {{Sphere{R}, 4 * pi * R * R},
                                                       {Cylinder{R, L}, 2 * pi * R * (R + L)}};
  double worst = 0;
  for (const auto& [shape, expected] : exact) {
    for (const int n : {1, 2}) {
      const double coarse = area(shape, 0.02, n) - expected, fine = area(shape, 0.005, n) - expected;
      const double order = std::log2(coarse / fine) / 2;
      EXPECT_NEAR(order, 2 * n, 0.15 * n) << n;
      worst = std::max(std::abs(order - 2 * n) / n, worst);
    }
    EXPECT_NEAR(area(shape, 0.02, 8), expected, 1e-13 * expected);
  }
  testing::expect_verified(
      {.quantity =
           "distance of the fitted order from 2n, over n (area of a ball and a can, n = 1 and 2 points along an edge)",
       .reference = "exact solution",
       .source = "Areas 4 pi R^2 and 2 pi R (R + L)",
       .uncertainty = "rounding",
       .tolerance = 0.15,
       .why = "Over two halvings: which cells are cut when varies a little."},
      worst);
}

// Prolate spheroid: 2 pi a^2 (1 + c/(a e) asin e), e^2 = 1 - a^2/c^2. Octahedron: eight plane triangles; with these
// axes the triangle a, b, b has the height sqrt(a^2 + b^2/2) over the side b sqrt 2.
TEST(GradedRuleVerification, AreasOfSuperquadrics) {
  const double a = 0.1, c = 0.2, e = std::sqrt(1 - a * a / (c * c));
  const double spheroid = 2 * pi * a * a * (1 + c / (a * e) * std::asin(e));
  EXPECT_NEAR(area(Superquadric{{a, a, c}, 1, 1}, 0.05, 8), spheroid, 1e-12 * spheroid);
  const double octahedron = 8 * 0.5 * a * std::sqrt(2.0) * std::sqrt(c * c + a * a / 2);
  EXPECT_NEAR(area(Superquadric{{c, a, a}, 2, 2}, 0.05, 8), octahedron, 1e-12 * octahedron);
}

// Where an exponent bends the surface sharply or without limit the areas still meet another rule's: within 1e-4 with
// cells of 1/30 of the extent (measured: 3e-5), and by an order of at least 1 (2/e; measured 1.4 and more).
TEST(GradedRuleVerification, AreasOfSharpSuperquadrics) {
  for (const auto& [e1, e2] : std::vector<std::pair<double, double>>{{0.1, 0.1}, {0.4, 1.5}, {1.5, 1.5}, {2, 0.5}}) {
    const Superquadric body{{0.3, 0.1, 0.2}, e1, e2};
    const double expected = surface_moments(body).area;
    EXPECT_NEAR(area(body, 0.02, 4), expected, 1e-4 * expected) << e1 << ' ' << e2;
    EXPECT_LT(std::abs(area(body, 0.02, 4) - expected), 0.25 * std::abs(area(body, 0.08, 4) - expected));
  }
}

// Divergence theorem: int n dA = 0 and int x . n dA = 3 V.
TEST(GradedRuleVerification, NormalsCloseTheSurface) {
  for (const Shape& shape : shapes) {
    const GradedRule rule = graded_rule(shape, {}, {0.04, 0.04, 0, 8});
    const bool tapered = std::holds_alternative<TaperedSuperquadric>(shape);
    const bool sharp = std::holds_alternative<Superquadric>(shape) || tapered;  // some of them are, as above
    const double enclosed = (rule.points.cwiseProduct(rule.normals)).colwise().sum().dot(rule.weights) / 3;
    EXPECT_NEAR(enclosed, volume(shape), (sharp ? 2e-5 : 1e-12) * volume(shape));
    // Symmetric cells: rounding alone; of tapered ones the rule's error, 2e-9 here.
    EXPECT_LT((rule.normals * rule.weights).norm(), (tapered ? 1e-8 : 1e-13) * rule.weights.sum());
    EXPECT_LT((rule.normals.colwise().norm().array() - 1).abs().maxCoeff(), 1e-15 * 4);
    EXPECT_GT(rule.weights.minCoeff(), 0);
  }
}

TEST(GradedRule, EverySurfacePointIsCoveredByASample) {
  for (const Shape& shape : shapes) {
    const auto points = random_surface_points(shape, 100, 3);
    const std::vector<Vector3d> foci = {points[0], points[1]};
    for (const Grading& grading : {Grading{1e-3, infinity, 0.5, 3}, Grading{1e-3, 0.03, 1, 1}}) {
      const GradedRule rule = graded_rule(shape, foci, grading);
      for (const Vector3d& x : points) EXPECT_LE(uncovered(rule, x), 0);
    }
  }
}

// Shares of about equal sides: the balls of these radii overlap, but not more than discs about squares do by the
// inequality of Gauss shares (n = 3: middle 0.39, outer 0.31 of the edge) and of the cells' sides (2 : 1).
TEST(GradedRule, RadiiAreNotWasteful) {
  for (const Shape& shape : {Shape{Box{{0.3, 0.2, 0.7}}}, Shape{Cylinder{0.05, 0.2}}, Shape{Sphere{0.07}}}) {
    const GradedRule rule = graded_rule(shape, {}, {0.01, 0.01, 0, 3});
    EXPECT_LT(pi * rule.radius.squaredNorm(), 4.5 * rule.weights.sum());
  }
}

// n = 3: a share reaches 0.194 of its cell's length from its sample in each direction, 0.274 across. The cell's d is
// not above the sample's distance; cells that hold a focus are of the finest however steep the grading.
TEST(GradedRule, CellsFollowTheDistanceFromTheFoci) {
  for (const Shape& shape : shapes)
    for (const double grading : {0.4, 3.0}) {
      const auto foci = random_surface_points(shape, 2, 5);
      const Grading g{1e-3, 0.05, grading, 3};
      const GradedRule rule = graded_rule(shape, foci, g);
      for (Index i = 0; i < rule.radius.size(); ++i) {
        const double h = std::min(g.coarsest, std::max(g.finest, g.grading * nearest(foci, rule.points.col(i))));
        EXPECT_LE(rule.radius[i], 0.32 * h);  // a sixth more: maps stretch the cell unevenly
      }
      for (const Vector3d& focus : foci) {
        Index at = 0;
        (rule.points.colwise() - focus).colwise().norm().minCoeff(&at);
        EXPECT_LE(rule.radius[at], 0.32 * g.finest);
      }
      EXPECT_GT(rule.radius.maxCoeff(), 2 * g.finest);
    }
}

// Rings of cells of the size of their distance: each halving of the finest adds as many.
TEST(GradedRule, CountGrowsWithTheLogarithmOfTheFinest) {
  const Vector3d focus(0, 0.0123, 0.35);
  const auto count = [&](double finest) {
    return graded_rule(Box{{0.3, 0.2, 0.7}}, {focus}, {finest, infinity, 0.5, 1}).weights.size();
  };
  const Index first = count(1e-4) - count(1e-3), second = count(1e-5) - count(1e-4), third = count(1e-6) - count(1e-5);
  EXPECT_NEAR(static_cast<double>(second), static_cast<double>(first), 0.2 * static_cast<double>(first));
  EXPECT_NEAR(static_cast<double>(third), static_cast<double>(second), 0.2 * static_cast<double>(second));
  EXPECT_LT(count(1e-6), 20000);
}

// A slender box is cut along its length alone until its cells are about square.
TEST(GradedRule, CellsAreHalvedOnlyAcrossWhatIsTooLong) {
  const GradedRule rule = graded_rule(Box{{1.28, 0.01, 0.01}}, {}, {0.011, 0.011, 0, 1});
  EXPECT_EQ(rule.weights.size(), 4 * 128 + 2);
}

// The part near the foci is a part of the whole: the same cells.
TEST(GradedRule, OnlyWhatLiesWithinADistance) {
  for (const Shape& shape : shapes) {
    const auto points = random_surface_points(shape, 200, 7);
    const std::vector<Vector3d> foci = {points[0]};
    const Grading g{1e-3, 0.03, 0.5, 2};
    const double within = 0.03;
    const GradedRule whole = graded_rule(shape, foci, g), part = graded_rule(shape, foci, g, within);
    EXPECT_LT(part.weights.size(), whole.weights.size());
    const auto near = [&](const GradedRule& rule) {
      return ((rule.points.colwise() - foci[0]).colwise().norm().array() <= within).count();
    };
    ASSERT_GT(near(whole), 0);
    ASSERT_EQ(near(part), near(whole));
    for (Index i = 0; i < part.weights.size(); ++i) {
      EXPECT_EQ((whole.points.colwise() - part.points.col(i)).colwise().norm().minCoeff(), 0);
      EXPECT_LT((part.points.col(i) - foci[0]).norm(), within + 2 * g.coarsest);  // the cell reaches in
    }
    for (const Vector3d& x : points)
      if ((x - foci[0]).norm() <= within) {
        EXPECT_LE(uncovered(part, x), 0);
      }
    EXPECT_EQ(graded_rule(shape, {{9, 9, 9}}, g, within).weights.size(), 0);
  }
}

TEST(GradedRule, AFocusOffTheSurfaceGradesByItsDistance) {
  const Grading g{1e-4, infinity, 0.5, 1};
  const GradedRule above = graded_rule(Sphere{0.07}, {{0, 0, 0.08}}, g),
                   on = graded_rule(Sphere{0.07}, {{0, 0, 0.07}}, g);
  EXPECT_LT(above.weights.size(), on.weights.size());
  EXPECT_LT(on.radius.minCoeff(), 1e-4);
  EXPECT_GT(above.radius.minCoeff(), 0.1 * 0.5 * 0.01);  // halved at most once more than the distance 0.01 asks for
}

TEST(GradedRule, WorksInUnitsOfAnySize) {
  const double expected = graded_rule(Sphere{1}, {{0, 0, 1}}, {0.01, 1, 0.5, 2}).weights.sum();
  for (const double R : {1e-100, 1e-9, 1e100}) {
    const GradedRule rule = graded_rule(Sphere{R}, {{0, 0, R}}, {0.01 * R, R, 0.5, 2});
    EXPECT_NEAR((rule.weights / R / R).sum(), expected, 1e-12 * expected);
    EXPECT_GT(rule.radius.minCoeff(), 0);
    EXPECT_LT(rule.radius.maxCoeff(), R);
  }
}

TEST(GradedRule, RefusesBadInput) {
  const Shape ball = Sphere{0.07};
  const double nan = std::nan("");
  const std::vector<Vector3d> focus = {{0, 0, 0.07}};
  const Grading good{1e-3, 0.1, 0.5, 2};
  EXPECT_NO_THROW(graded_rule(ball, focus, good));
  for (const Grading& bad : {Grading{0, 0.1, 0.5, 2}, Grading{nan, 0.1, 0.5, 2}, Grading{1e-12, 0.1, 0.5, 2},
                             Grading{infinity, infinity, 1, 2}, Grading{0.1, 0.01, 0.5, 2}, Grading{1e-3, nan, 0.5, 2},
                             Grading{1e-3, 0.1, -1, 2}, Grading{1e-3, 0.1, nan, 2}, Grading{1e-3, 0.1, infinity, 2},
                             Grading{1e-3, 0.1, 0.5, 0}, Grading{1e-3, 0.1, 0.5, 17}})
    EXPECT_THROW(graded_rule(ball, focus, bad), std::invalid_argument);
  EXPECT_THROW(graded_rule(ball, {{0, nan, 0}}, good), std::invalid_argument);
  EXPECT_THROW(graded_rule(ball, focus, good, nan), std::invalid_argument);
  EXPECT_THROW(graded_rule(ball, focus, good, -1), std::invalid_argument);
  EXPECT_THROW(graded_rule(ball, {}, good, 0.1), std::invalid_argument);
  EXPECT_THROW(graded_rule(Sphere{nan}, focus, good), std::invalid_argument);
  try {
    graded_rule(Box{{0.1, 0.1, 0.1}}, focus, {1e-6, 1e-6, 0, 1});
    FAIL() << "too many cells";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("finest 1e-06 m"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace mb
