#include "reference/fem/superquadric_mesh.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <gtest/gtest.h>

#include <array>

#include "mechanics/algebra/worse_test.h"
#include "mechanics/geometry/signed_distance.h"
#include "mechanics/rigid/inertia.h"
#include "mechanics/verified_test.h"
#include "reference/fem/discretisation.h"
#include "reference/fem/evaluation.h"

namespace mb::fem {
namespace {

const Shape pebble = Superquadric{{0.1, 0.075, 0.105}, 1, 1};
const Shape pillow = Superquadric{{0.0885, 0.0664, 0.0929}, 0.6, 0.6};
const Shape pear = TaperedSuperquadric{{{0.0958, 0.0718, 0.1104}, 1, 1}, 0.4};

// Of the mesh: volume and moments of inertia by an exact enough rule, the least and largest det J of a cell (ratio) at
// Gauss points, at nodes and on a grid with the corners.
struct Measures {
  double volume = 0, flattest = 1;
  Vector3d square = Vector3d::Zero();
};
Measures measures(const Discretisation& d) {
  Measures all;
  const auto p = static_cast<unsigned>(d.element.degree);
  for (const dealii::Quadrature<3>& rule :
       {dealii::Quadrature<3>(dealii::QGauss<3>(p + 3)), dealii::Quadrature<3>(dealii::QGaussLobatto<3>(p + 1)),
        dealii::Quadrature<3>(dealii::QIterated<3>(dealii::QTrapezoid<1>(), 5))}) {
    dealii::FEValues<3> values(d.mapping, d.element, rule,
                               dealii::update_JxW_values | dealii::update_jacobians | dealii::update_quadrature_points);
    const bool gauss = rule.size() == (p + 3) * (p + 3) * (p + 3) && all.volume == 0;
    Measures here = all;
    for (const auto& cell : d.nodes.active_cell_iterators()) {
      values.reinit(cell);
      double least = 1e300, most = 0;
      for (unsigned q = 0; q < rule.size(); ++q) {
        const double J = values.jacobian(q).determinant();
        least = std::min(least, J), most = std::max(most, J);
        if (!gauss) continue;
        here.volume += values.JxW(q);
        for (unsigned i = 0; i < 3; ++i)
          here.square[i] += values.JxW(q) * values.quadrature_point(q)[i] * values.quadrature_point(q)[i];
      }
      here.flattest = std::min(here.flattest, least / most);
    }
    all = here;
  }
  return all;
}

// The slope of log error by log of the cells' size, over the last halving.
double order(double coarse, double fine) { return std::log2(std::abs(coarse / fine)); }

// Cells are no flatter than those of coarse balls (grading.h), over all exponents and tapers that cases may state. The
// semi-axes scale all Jacobians alike.
TEST(SuperquadricMesh, HasSoundCells) {
  for (const double e1 : {0.4, 1.0, 1.4})
    for (const double e2 : {0.4, 1.0, 1.4})
      for (const double share : {-1.0, 0.0, 0.5})
        for (int degree = 1; degree <= 4; ++degree)
          for (const int splits : {1, 2}) {
            const TaperedSuperquadric body{{{1, 0.7, 0.3}, e1, e2}, share * std::min(0.45, largest_taper(e1))};
            const double flattest = measures(Discretisation(body, {degree, {splits}})).flattest;
            EXPECT_GT(flattest, 0.01) << e1 << ' ' << e2 << ' ' << body.taper << ' ' << degree << ' ' << splits;
          }
}

// What the orders of volume and moments lack to 2p, degrees p = 1, 2, 3, the worst; `less` is allowed.
double lacking(const Shape& shape, double less) {
  const Eigen::Matrix3d J = mass_properties(shape, 1).inertia;
  const Vector3d exact = Vector3d::Constant(J.trace() / 2) - J.diagonal();
  double worst = 0;
  for (const int degree : {1, 2, 3}) {
    std::array<double, 3> volumes, squares;
    for (int level = 0; level < 3; ++level) {
      const Measures here = measures(Discretisation(shape, {degree, {2 << level}}));
      volumes[level] = here.volume / volume(shape) - 1;
      squares[level] = (here.square - exact).norm() / exact.norm();
    }
    for (const double found : {order(volumes[1], volumes[2]), order(squares[1], squares[2])}) {
      EXPECT_GT(found, 2 * degree - less) << shape.index() << ' ' << degree;
      worst = worse(worst, 2 * degree - found);
    }
  }
  return worst;
}

void expect_order(const std::string& bodies, double tolerance, const std::string& why, double error) {
  mb::testing::expect_verified(
      {.quantity =
           "what the order in the mesh of volume and moments lacks to 2p, degrees p = 1, 2, 3, absolute: " + bodies,
       .reference = "exact solution",
       .source = "moments of superquadrics by gamma functions, mechanics/geometry/superquadric.h",
       .uncertainty = "rounding",
       .tolerance = tolerance,
       .why = why},
      error);
}

// Of order 2p: nodes at Gauss-Lobatto points make up for each other. The pillow's surface is smooth but for finitely
// many derivatives on the coordinate planes (2/e = 3.33): 3.7 and 5.4 were measured.
TEST(SuperquadricMeshVerification, VolumeAndInertiaConverge) {
  expect_order("ellipsoid and tapered ellipsoid", 0.15, "The last of two halvings is nearly in the asymptotic range.",
               std::max(lacking(pebble, 0.15), lacking(pear, 0.15)));
  expect_order(
      "superquadric of exponents 0.6", 0.75,
      "Its surface has few derivatives on the coordinate planes, 2/e = 3.33: 3.7 and 5.4 were seen of 4 and 6.",
      lacking(pillow, 0.75));
}

// Of every face points between its nodes: to order p + 1 on the exact surface; at the nodes to rounding.
TEST(SuperquadricMeshVerification, FacesLieOnTheSurface) {
  for (const Shape& shape : {pebble, pear})
    for (const int degree : {1, 2, 3, 4}) {
      std::array<double, 2> off;
      for (int level = 0; level < 2; ++level) {
        const Discretisation d(shape, {degree, {2 << level}});
        off[level] = 0;
        const dealii::QIterated<2> grid(dealii::QTrapezoid<1>(), 3);
        dealii::FEFaceValues<3> face(d.mapping, d.element, grid, dealii::update_quadrature_points);
        for (const auto& cell : d.nodes.active_cell_iterators())
          for (const unsigned f : cell->face_indices()) {
            if (!cell->face(f)->at_boundary()) continue;
            face.reinit(cell, f);
            for (unsigned q = 0; q < grid.size(); ++q) {
              const auto& x = face.quadrature_point(q);
              off[level] = worse(off[level], std::abs(signed_distance_value(shape, {x[0], x[1], x[2]})));
            }
          }
      }
      EXPECT_GT(order(off[0], off[1]), degree + 0.5) << shape.index() << ' ' << degree;
      EXPECT_LT(off[1], 0.02 * extent(shape));
    }
  for (const Shape& shape : {pebble, pillow, pear}) {
    const Discretisation d(shape, {4, {1}});
    const Matrix3Xd x = d.node_positions();
    int n_on = 0;
    for (Index i = 0; i < x.cols(); ++i) {
      const double off = std::abs(signed_distance_value(shape, x.col(i)));
      n_on += off < 1e-12 ? 1 : 0;
    }
    EXPECT_EQ(n_on, 6 * 16 + 2) << shape.index();  // (p splits)^2 a block, Euler's formula
  }
}

// e = 1 and equal axes are the ball: the same nodes.
TEST(SuperquadricMesh, OfABallIsTheBalls) {
  for (const int degree : {1, 2, 4}) {
    const Matrix3Xd ball = Discretisation(Sphere{0.1}, {degree, {2}}).node_positions();
    const Matrix3Xd same = Discretisation(Superquadric{{0.1, 0.1, 0.1}, 1, 1}, {degree, {2}}).node_positions();
    EXPECT_LT((ball - same).cwiseAbs().maxCoeff(), 1e-14) << degree;  // of the radius 1e-13: projections
  }
}

TEST(SuperquadricMesh, IsGradedAndEvaluatesAtEveryPoint) {
  for (const Shape& shape : {pebble, pillow, pear}) {
    const Vector3d focus = surface_quadrature(shape).points.col(7);
    for (const Resolution& resolution : {Resolution{1, {1}}, Resolution{2, {2}, 2}, Resolution{4, {1}, 1}}) {
      const Discretisation d(shape, resolution, {focus});
      EXPECT_GT(measures(d).flattest, 0.01);
      const VectorXd nodes = d.node_positions().reshaped();
      for (const Matrix3Xd& x : {volume_quadrature(shape).points, surface_quadrature(shape).points}) {
        const SparseMatrix N = displacement_at(d, x);
        EXPECT_LT((N * nodes - x.reshaped()).cwiseAbs().maxCoeff(), 1e-11);
      }
    }
    EXPECT_THROW(Discretisation(shape, {2, {3}}), std::invalid_argument);
    EXPECT_THROW(Discretisation(shape, {2, {1, 1}}), std::invalid_argument);
    EXPECT_THROW(Discretisation(shape, {2, {1}, 1}, {Vector3d(0.3, 0, 0)}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace mb::fem
