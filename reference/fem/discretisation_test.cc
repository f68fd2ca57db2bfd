#include "reference/fem/discretisation.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <gtest/gtest.h>

#include "reference/fem/box_mesh.h"
#include "reference/fem/evaluation.h"

namespace mb::fem {
namespace {

const Shape cylinder = Cylinder{0.05, 0.2};

struct Jacobians {
  double least, volume;  // [m^3] least of det J, and its integral
};
Jacobians jacobians(const Discretisation& d, const dealii::Quadrature<3>& rule) {
  dealii::FEValues<3> values(d.mapping, d.element, rule, dealii::update_JxW_values | dealii::update_jacobians);
  Jacobians sum{1, 0};
  for (const auto& cell : d.nodes.active_cell_iterators()) {
    values.reinit(cell);
    for (unsigned q = 0; q < rule.size(); ++q) {
      sum.least = std::min(sum.least, values.jacobian(q).determinant());
      sum.volume += values.JxW(q);
    }
  }
  return sum;
}

TEST(OneBlockCylinder, HasTheNodesOfOneColumnOfCells) {
  for (int degree = 1; degree <= 4; ++degree)
    for (const int layers : {1, 3}) {
      const Discretisation d(cylinder, {degree, {0, layers}});
      EXPECT_EQ(d.n_nodes(), (degree + 1) * (degree + 1) * (degree * layers + 1));
      EXPECT_EQ(d.mesh.n_active_cells(), static_cast<unsigned>(layers));
    }
}

// Positive at every Gauss point, at every node (lumping), and on a fine grid that holds the corners.
TEST(OneBlockCylinder, HasPositiveJacobians) {
  for (int degree = 1; degree <= 4; ++degree)
    for (const int layers : {1, 4}) {
      const Discretisation d(cylinder, {degree, {0, layers}});
      const unsigned p = static_cast<unsigned>(degree);
      const dealii::QIterated<3> grid(dealii::QTrapezoid<1>(), 16);
      for (const dealii::Quadrature<3>& rule :
           {dealii::Quadrature<3>(dealii::QGauss<3>(p + 1)), dealii::Quadrature<3>(dealii::QGaussLobatto<3>(p + 1)),
            dealii::Quadrature<3>(grid)})
        EXPECT_GT(jacobians(d, rule).least, 0.02 * volume(cylinder) / layers) << degree << " " << layers;
    }
}

// The inscribed prism, then four parabolas; the error falls as the degree grows.
TEST(OneBlockCylinder, ApproachesTheVolume) {
  const auto error = [](int degree) {
    const Discretisation d(cylinder, {degree, {0, 2}});
    return 1 - jacobians(d, dealii::QGauss<3>(6)).volume / volume(cylinder);
  };
  EXPECT_NEAR(error(1), 1 - 2 / pi, 1e-13);
  // A parabola over the chord sqrt 2 R, height R (1 - sqrt 1/2): two thirds of the rectangle.
  EXPECT_NEAR(error(2), 1 - (2 + 4 * (2.0 / 3) * std::sqrt(2.0) * (1 - std::sqrt(0.5))) / pi, 1e-13);
  EXPECT_LT(std::abs(error(3)), 1e-3);
  EXPECT_LT(std::abs(error(4)), 1e-4);
}

TEST(OneBlockCylinder, NamesItsFaces) {
  const Discretisation d(cylinder, {1, {0, 3}});
  std::map<std::string, int> count;
  for (const auto& quad : d.mesh.active_face_iterators())
    if (quad->at_boundary()) ++count[d.faces[quad->boundary_id()]];
  EXPECT_EQ(count, (std::map<std::string, int>{{"side", 12}, {"z-min", 1}, {"z-max", 1}}));
}

// Points of the exact shape, up to 0.29 R outside the prism.
TEST(OneBlockCylinder, EvaluatesAtEveryPointOfTheExactShape) {
  for (int degree = 1; degree <= 4; ++degree)
    for (const int layers : {1, 3}) {
      const Discretisation d(cylinder, {degree, {0, layers}});
      const VectorXd nodes = d.node_positions().reshaped();
      for (const Matrix3Xd& x : {volume_quadrature(cylinder).points, surface_quadrature(cylinder).points}) {
        const SparseMatrix N = displacement_at(d, x);
        EXPECT_LT((N * nodes - x.reshaped()).cwiseAbs().maxCoeff(), 1e-11 * 0.2);
        EXPECT_LT(N.coeffs().cwiseAbs().maxCoeff(), 2);  // no wild extrapolation
      }
    }
  EXPECT_THROW(displacement_at(Discretisation(cylinder, {2, {0, 1}}), Vector3d(0.3, 0, 0)), std::invalid_argument);
}

TEST(Discretisation, RefusesResolutionsOutOfRange) {
  const Shape box = Box{{1, 1, 1}}, sphere = Sphere{1};
  for (const auto& [shape, resolution] : std::vector<std::pair<Shape, Resolution>>{{box, {0, {1, 1, 1}}},
                                                                                   {box, {5, {1, 1, 1}}},
                                                                                   {box, {1, {1, 1}}},
                                                                                   {box, {1, {0, 1, 1}}},
                                                                                   {box, {1, {1, 1, 1025}}},
                                                                                   {cylinder, {1, {-1, 1}}},
                                                                                   {cylinder, {1, {0, 0}}},
                                                                                   {cylinder, {1, {3, 1}}},
                                                                                   {cylinder, {1, {1}}},
                                                                                   {sphere, {1, {0}}},
                                                                                   {sphere, {1, {6}}},
                                                                                   {sphere, {1, {}}}})
    EXPECT_THROW(Discretisation(shape, resolution), std::invalid_argument) << shape.index() << to_string(resolution);
}

TEST(BoxMesh, GrowsGeometrically) {
  const auto places = biased_places(1.5, 4, 8);  // 0.1, 0.2, 0.4, 0.8 m
  const std::vector<double> expected{-0.75, -0.65, -0.45, -0.05, 0.75};
  for (size_t i = 0; i < places.size(); ++i) EXPECT_NEAR(places[i], expected[i], 1e-15) << i;
  EXPECT_EQ(biased_places(2, 1, 8), (std::vector<double>{-1, 1}));
}

TEST(BoxMesh, DistortedKeepsVolumeFacesAndNodesOfTheFaces) {
  const Shape box = Box{{0.3, 0.2, 0.5}};
  const Discretisation even(box, {2, {3, 4, 5}}), moved(box, {2, {3, 4, 5}, 0, {}, 0.25});
  EXPECT_NEAR(jacobians(moved, dealii::QGauss<3>(3)).volume, volume(box), 1e-15);
  EXPECT_LT(jacobians(moved, dealii::QGauss<3>(3)).least, 0.6 * jacobians(even, dealii::QGauss<3>(3)).least);
  const Matrix3Xd x = even.node_positions(), y = moved.node_positions();
  const Eigen::Array3d cell(0.1, 0.05, 0.1);  // [m]
  for (Index a = 0; a < x.cols(); ++a)
    for (Index i = 0; i < 3; ++i) {
      const bool on_face = std::abs(std::abs(x(i, a)) - extents(box)[i] / 2) < 1e-12;
      EXPECT_LE(std::abs(x(i, a) - y(i, a)), on_face ? 1e-15 : 0.25 * cell[i] * (1 + 1e-12)) << a;
    }
  EXPECT_GT((x - y).norm(), 0.1 * 0.05 * std::sqrt(static_cast<double>(x.cols())));
  EXPECT_EQ(Discretisation(box, {2, {3, 4, 5}, 0, {}, 0.25}).node_positions(), y) << "always alike";
}

TEST(BoxMesh, RefusesWhatNoBoxTakes) {
  const Shape box = Box{{1, 1, 1}};
  for (const Resolution& wrong : {Resolution{1, {2, 2, 2}, 0, {1, 1}}, Resolution{1, {2, 2, 2}, 0, {1, 1, 0}},
                                  Resolution{1, {2, 2, 2}, 0, {}, 0.5}, Resolution{1, {2, 2, 2}, 0, {}, -0.1}})
    EXPECT_THROW(Discretisation(box, wrong), std::invalid_argument) << to_string(wrong);
  EXPECT_THROW(Discretisation(cylinder, {1, {1, 2}, 0, {}, 0.1}), std::invalid_argument);
  EXPECT_THROW(Discretisation(cylinder, {1, {1, 2}, 0, {1, 1, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace mb::fem
