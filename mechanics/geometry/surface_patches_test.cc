#include "mechanics/geometry/surface_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/signed_distance.h"

namespace mb {
namespace {

// Sizes unlike each other, and the exponents' corners: edges on the planes through the centre (2), almost a box (0.1).
const std::vector<Shape> shapes = {Box{{0.3, 0.2, 0.7}},
                                   Box{{1.2, 0.038, 0.089}},
                                   Cylinder{0.05, 0.2},
                                   Cylinder{0.3, 0.01},
                                   Sphere{0.07},
                                   Superquadric{{0.3, 0.1, 0.2}, 1, 1},
                                   Superquadric{{0.3, 0.1, 0.2}, 0.4, 1.5},
                                   Superquadric{{0.1, 0.1, 0.3}, 0.1, 0.1},
                                   Superquadric{{0.2, 0.1, 0.1}, 2, 2},
                                   TaperedSuperquadric{{{0.1, 0.08, 0.12}, 0.8, 1.2}, 0.6}};

double p_norm(double a, double b, double p) { return std::pow(std::pow(a, p) + std::pow(b, p), 1 / p); }

// 1 on the surface, homogeneous of degree one; written from the definitions, not from the maps.
double level(const Shape& shape, const Vector3d& x) {
  return std::visit(overloaded{[&](const Box& b) { return 2 * (x.cwiseQuotient(b.size)).cwiseAbs().maxCoeff(); },
                               [&](const Cylinder& c) {
                                 return std::max(x.head<2>().norm() / c.radius, 2 * std::abs(x[2]) / c.length);
                               },
                               [&](const Sphere& s) { return x.norm() / s.radius; },
                               [&](const Superquadric& q) {
                                 const Vector3d y = x.cwiseQuotient(q.semi_axes).cwiseAbs();
                                 return p_norm(p_norm(y[0], y[1], 2 / q.e2), y[2], 2 / q.e1);
                               },
                               [&](const TaperedSuperquadric& q) {
                                 const double z = x[2] + Taper(q).shift(),
                                              c = 1 + q.taper * z / q.straight.semi_axes[2];
                                 return level(q.straight, {x[0] / c, x[1] / c, z});
                               }},
                    shape);
}

double size(const Shape& shape) {
  double largest = 0;
  for (const SurfacePatch& patch : surface_patches(shape))
    largest = std::max(largest, patch.at(0.5, 0.5).x.lpNorm<Eigen::Infinity>());
  return largest;
}

TEST(SurfacePatches, PointsLieOnTheSurface) {
  for (const Shape& shape : shapes)
    for (const SurfacePatch& patch : surface_patches(shape))
      for (const double s : {0.0, 0.13, 0.5, 0.8, 1.0})
        for (const double t : {0.0, 0.2, 0.5, 0.77, 1.0})
          EXPECT_NEAR(level(shape, patch.at(s, t).x), 1, 2e-15) << s << ' ' << t;  // a few roundings
}

// Central differences: truncation step^2 |x'''| / 6, with |x'''| up to (2/e)^2 sizes; rounding 1e-16 / step.
TEST(SurfacePatches, DerivativesAreThoseOfTheMap) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> inside(0.1, 0.9);  // where exponents above 1 have a bounded x'''
  const double h = 1e-6;
  for (const Shape& shape : shapes)
    for (const SurfacePatch& patch : surface_patches(shape))
      for (int trial = 0; trial < 20; ++trial) {
        const double s = inside(random), t = inside(random);
        const SurfacePoint p = patch.at(s, t);
        const Vector3d by_s = (patch.at(s + h, t).x - patch.at(s - h, t).x) / (2 * h);
        const Vector3d by_t = (patch.at(s, t + h).x - patch.at(s, t - h).x) / (2 * h);
        EXPECT_LT((p.by_s - by_s).norm(), 3e-9 * size(shape));
        EXPECT_LT((p.by_t - by_t).norm(), 3e-9 * size(shape));
      }
}

// The bodies are convex around the origin: outward is where normal . x > 0, here at least half the thickness.
TEST(SurfacePatches, NormalsPointOutwardEverywhere) {
  const std::vector<double> all = {0, 1e-9, 0.1, 0.5, 0.9, 1};
  for (const Shape& shape : shapes) {
    for (const SurfacePatch& patch : surface_patches(shape))
      for (const double s : all)
        for (const double t : all) {
          const SurfacePoint p = patch.at(s, t);
          const Vector3d area = p.by_s.cross(p.by_t);
          ASSERT_GT(area.norm(), 0);
          const double thickness = std::visit(
              overloaded{[](const Box& b) { return b.size.minCoeff(); },
                         [](const Cylinder& c) { return std::min(2 * c.radius, c.length); },
                         [](const Sphere& b) { return 2 * b.radius; },
                         // a norm above the 1-norm's body: the octahedron's inscribed ball
                         [](const Superquadric& q) { return 2 / q.semi_axes.cwiseInverse().norm(); },
                         [](const TaperedSuperquadric& q) { return -2 * signed_distance_value(q, Vector3d::Zero()); }},
              shape);
          EXPECT_GE(area.normalized().dot(p.x), (1 - 1e-12) * thickness / 2);
        }
  }
}

// What the header says of the ends' blocks: no degenerate point, corners included.
TEST(SurfacePatches, AreaElementsOfACylindersEndAreBounded) {
  const double R = 0.05;
  const auto patches = surface_patches(Cylinder{R, 0.2});
  double least = 1, most = 0;
  for (std::size_t k = 4; k < patches.size(); ++k)
    for (double s = 0; s <= 1; s += 0.0625)
      for (double t = 0; t <= 1; t += 0.0625) {
        const SurfacePoint p = patches[k].at(s, t);
        least = std::min(least, p.by_s.cross(p.by_t).norm() / (R * R));
        most = std::max(most, p.by_s.cross(p.by_t).norm() / (R * R));
      }
  EXPECT_NEAR(least, 0.24, 0.005);
  EXPECT_NEAR(most, 0.905, 0.005);
}

// Every edge coincides with one edge of another patch, at the same parameter or one less it.
TEST(SurfacePatches, NeighboursShareWholeEdges) {
  const auto on_edge = [](const SurfacePatch& patch, int edge, double r) -> Vector3d {
    return edge == 0   ? patch.at(r, 0).x
           : edge == 1 ? patch.at(1, r).x
           : edge == 2 ? patch.at(r, 1).x
                       : patch.at(0, r).x;
  };
  for (const Shape& shape : shapes) {
    const auto patches = surface_patches(shape);
    const double tolerance = 1e-15 * 4 * size(shape);
    const auto same = [&](std::size_t p, int a, std::size_t q, int b, bool turned) {
      for (const double r : {0.0, 0.3, 0.5, 0.9, 1.0})
        if ((on_edge(patches[p], a, r) - on_edge(patches[q], b, turned ? 1 - r : r)).norm() > tolerance) return false;
      return true;
    };
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (int a = 0; a < 4; ++a) {
        int partners = 0;
        for (std::size_t q = 0; q < patches.size(); ++q)
          for (int b = 0; b < 4; ++b)
            if (q != p) partners += same(p, a, q, b, false) || same(p, a, q, b, true);
        EXPECT_EQ(partners, 1);
      }
  }
}

struct Cover {
  double bound, reached; /* [m] */
};
// The bound, and the farthest of a grid of the cell's points.
Cover cover(const SurfacePatch& patch, const ParameterCell& c, double s, double t) {
  const Vector3d x = patch.at(s, t).x;
  double reached = 0;
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j)
      reached = std::max(reached, (patch.at(c.s0 + (c.s1 - c.s0) * i / 8, c.t0 + (c.t1 - c.t0) * j / 8).x - x).norm());
  return {patch.covering_radius(c, s, t), reached};
}

TEST(SurfacePatches, CoveringRadiusIsABound) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Shape& shape : shapes)
    for (const SurfacePatch& patch : surface_patches(shape))
      for (int trial = 0; trial < 30; ++trial) {
        const double width = std::pow(0.5, trial % 10), s0 = unit(random) * (1 - width),
                     t0 = unit(random) * (1 - width);
        const ParameterCell cell{s0, s0 + width, t0, t0 + width};
        const Cover c = cover(patch, cell, s0 + unit(random) * width, t0 + unit(random) * width);
        EXPECT_LE(c.reached, c.bound);
      }
}

// Attained where the map is affine or a cylinder's; else the excess is of second order while the surface is smooth.
TEST(SurfacePatches, CoveringRadiusIsTight) {
  for (const Shape& shape : shapes)
    for (const SurfacePatch& patch : surface_patches(shape))
      for (const double width : {1.0 / 4, 1.0 / 64}) {
        const Cover c = cover(patch, {0.4, 0.4 + width, 0.3, 0.3 + width}, 0.4 + 0.4 * width, 0.3 + 0.6 * width);
        if (std::holds_alternative<Box>(shape)) {
          EXPECT_LT(c.bound, c.reached + 1e-14 * size(shape));  // what the bound leaves for rounding
        }
        EXPECT_LT(c.bound, (1 + 1.5 * width) * c.reached);
      }
}

TEST(SurfacePatches, ALargeCellOfARoundSurfaceIsCoveredWithinReason) {
  for (const SurfacePatch& patch : surface_patches(Sphere{0.07})) {
    const Cover c = cover(patch, {}, 0.5, 0.5);
    EXPECT_LT(c.bound, 1.6 * c.reached);  // the tangent plane over a sixth of the sphere
  }
}

TEST(SurfacePatches, RefusesBadShapes) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, infinite}) {
    EXPECT_THROW(surface_patches(Box{{0.1, bad, 0.1}}), std::invalid_argument);
    EXPECT_THROW(surface_patches(Cylinder{bad, 0.1}), std::invalid_argument);
    EXPECT_THROW(surface_patches(Cylinder{0.1, bad}), std::invalid_argument);
    EXPECT_THROW(surface_patches(Sphere{bad}), std::invalid_argument);
    EXPECT_THROW(surface_patches(Superquadric{{0.1, 0.1, bad}, 1, 1}), std::invalid_argument);
    EXPECT_THROW(surface_patches(Superquadric{{0.1, 0.1, 0.1}, bad, 1}), std::invalid_argument);
  }
  EXPECT_THROW(surface_patches(Superquadric{{0.1, 0.1, 0.1}, 1, 2.5}), std::invalid_argument);
  EXPECT_TRUE(std::isnan(surface_patches(Sphere{0.1})[0].at(nan, 0.5).x.sum()));
}

}  // namespace
}  // namespace mb
