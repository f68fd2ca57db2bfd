#include <gtest/gtest.h>

#include "mechanics/geometry/disc_rule.h"
#include "reference/fem/assembly.h"
#include "reference/fem/discretisation.h"
#include "reference/fem/evaluation.h"
#include "reference/static_answer.h"

namespace mb::fem {
namespace {

const Shape cylinder = Cylinder{0.05, 0.2}, sphere = Sphere{0.07};

struct Resultant {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();  // [N], [N m] about the origin
};
Resultant resultant(const Discretisation& d, const VectorXd& load) {
  const Matrix3Xd x = d.node_positions();
  Resultant sum;
  for (Index a = 0; a < d.n_nodes(); ++a) {
    sum.force += load.segment<3>(3 * a);
    sum.moment += x.col(a).cross(load.segment<3>(3 * a));
  }
  return sum;
}

TEST(Loads, EndTractionsAreInBalanceAndPatchesSum) {
  const Discretisation d(cylinder, {4, {1, 4}});
  const VectorXd ends = patch_load(d, {"z-min", {}}, {0, 0, 400}) + patch_load(d, {"z-max", {}}, {0, 0, -400});
  const VectorXd top = patch_load(d, {"z-max", {}}, {0, 0, -400});
  double force = 0, sum = 0;
  for (Index a = 0; a < d.n_nodes(); ++a) sum += ends[3 * a + 2], force += top[3 * a + 2];
  const double area = pi * 0.05 * 0.05;
  EXPECT_NEAR(force, -400 * area, 400 * area * 2e-5);  // boundary error of quartics on five blocks
  EXPECT_NEAR(sum, 0, 1e-12 * 400 * area);
  EXPECT_THROW(patch_load(d, {"z-max", Disc{{5, 0, 0.1}, 0.03}}, {1, 0, 0}), std::invalid_argument);
}

// Force pi a^2/3 t and its moment about the origin, on every mesh, for discs small against its cells too.
TEST(Loads, DiscsHaveTheSameResultantOnEveryMesh) {
  const Vector3d t(3, -5, 7);
  for (const Resolution& resolution : {Resolution{1, {1, 2}}, Resolution{2, {1, 2}}, Resolution{4, {2, 4}}})
    for (const double a : {0.002, 0.008, 0.02}) {
      const Discretisation d(cylinder, resolution);
      const Vector3d centre(0.02, 0.01, 0.1);
      const VectorXd load = patch_load(d, {"z-max", Disc{centre, a}}, t);
      const Resultant sum = resultant(d, load);
      const Vector3d expected = pi * a * a / 3 * t;
      EXPECT_LT((sum.force - expected).norm(), 1e-12 * expected.norm()) << to_string(resolution) << " " << a;
      // Newton's inversion of the mapping places the points to about 1e-12.
      EXPECT_LT((sum.moment - centre.cross(expected)).norm(), 1e-10 * 0.1 * expected.norm())
          << to_string(resolution) << " " << a;
    }
}

// A quarter of a disc on a corner, against a grid of midpoints in Cartesian coordinates: the loads of all nodes, on
// meshes whose nodes are 6 to 26 to the radius. Loads at fixed points would be 9 to 250 % off.
TEST(Loads, OfADiscAreThoseOfItsWeightOnFineMeshesToo) {
  const Shape box = Box{{0.1, 0.1, 0.05}};
  const Patch patch{"z-max", Disc{{-0.05, -0.05, 0.025}, 0.08}};
  constexpr int n = 320;
  Matrix3Xd points(3, n * n), forces = Matrix3Xd::Zero(3, n * n);
  for (Index i = 0; i < n * n; ++i) {
    const double side = 0.08 / n, x = (static_cast<double>(i % n) + 0.5) * side,
                 y = (static_cast<double>(i / n) + 0.5) * side;
    points.col(i) = Vector3d(x - 0.05, y - 0.05, 0.025);
    forces(2, i) = weight(patch, points.col(i)) * side * side;
  }
  for (const Resolution& resolution : {Resolution{4, {2, 2, 1}}, Resolution{4, {4, 4, 1}}, Resolution{4, {8, 8, 1}}}) {
    const Discretisation d(box, resolution);
    const VectorXd expected = nodal_loads(d, points, forces), load = patch_load(d, patch, {0, 0, 1});
    // Four points a node: 1.4 % at most, of shape functions that bend where cells meet.
    EXPECT_LT((load - expected).norm(), 0.02 * expected.norm()) << to_string(resolution);
  }
}

// Strains at fixed points in a pressed block have a limit as its mesh is refined.
TEST(Loads, OfADiscHaveAMeshConvergedAnswer) {
  const auto strain = [](const Resolution& resolution) {
    Scene scene = one_body(Box{{0.1, 0.1, 0.05}}, {2e5, 0.3, 1100}, resolution);
    testing::load(scene, "z-max", Vector3d::Zero(), 100);
    scene.loads[0].tractions[0].patch.disc = Disc{{0.01, 0, 0.025}, 0.03};
    return testing::static_answer(scene).strain;
  };
  const MatrixXd finest = strain({4, {6, 6, 3}});
  const auto error = [&](const MatrixXd& e) {
    return (e - finest).cwiseAbs().maxCoeff() / finest.cwiseAbs().maxCoeff();
  };
  const double coarse = error(strain({4, {2, 2, 1}})), fine = error(strain({4, {4, 4, 2}}));
  EXPECT_LT(fine, 0.03);
  EXPECT_LT(fine, coarse / 5);  // a ninth; a third where loads are the same points on every mesh
}

// Of degree 3 p - 1 per direction and face, p + 2 Gauss points are exact to 2 p + 3: in balance for every p <= 4.
TEST(Pressure, AllOverABodyIsInBalance) {
  const double p = 1e5;
  for (const Shape& shape : {Shape(Box{{0.3, 0.2, 0.5}}), cylinder, sphere})
    for (int degree = 1; degree <= 4; ++degree) {
      const std::vector<int> cells[] = {{2, 1, 1}, {degree % 2, 2}, {1}};
      const Discretisation d(shape, {degree, cells[shape.index()]});
      VectorXd f = VectorXd::Zero(d.n_dofs());
      for (const auto& face : d.faces) f += patch_load(d, {face, {}}, Vector3d::Zero(), p);
      const Resultant sum = resultant(d, f);
      const double size = f.cwiseAbs().sum();
      EXPECT_LT(sum.force.norm(), 1e-13 * size) << degree << " of shape " << shape.index();
      EXPECT_LT(sum.moment.norm(), 1e-13 * size * extent(shape)) << degree << " of shape " << shape.index();
    }
}

TEST(Pressure, OfPlaneFacesIsATraction) {
  const Discretisation d(cylinder, {2, {1, 2}});
  for (const Patch& patch : {Patch{"z-min", {}}, Patch{"z-min", Disc{{0.01, 0, -0.1}, 0.03}}}) {
    const VectorXd both = patch_load(d, patch, {1, 2, 3}, 5), traction = patch_load(d, patch, {1, 2, 3 + 5});
    EXPECT_LT((both - traction).norm(), 1e-13 * traction.norm());
  }
  EXPECT_EQ(patch_load(d, {"side", {}}, {1, 2, 3}, 0), patch_load(d, {"side", {}}, {1, 2, 3}));
}

// By symmetry the force of a disc's pressure points along the inward normal at its centre; its moment vanishes.
TEST(Pressure, OfDiscsActsAlongTheExactNormal) {
  const Vector3d n = Vector3d(1, -2, 2) / 3;
  const DiscRule rule = disc_rule(sphere, {"surface", Disc{0.07 * n, 0.03}}, 1);
  const Vector3d expected = -8 * (rule.normals * rule.weights);
  for (const Resolution& resolution : {Resolution{1, {1}}, Resolution{2, {2}}, Resolution{3, {1}}}) {
    const Discretisation d(sphere, resolution);
    const Resultant sum = resultant(d, patch_load(d, {"surface", Disc{0.07 * n, 0.03}}, Vector3d::Zero(), 8));
    EXPECT_LT((sum.force - expected).norm(), 1e-12 * expected.norm());
    EXPECT_LT(sum.force.cross(n).norm(), 1e-12 * expected.norm());
    EXPECT_LT(sum.force.dot(n), 0);
    EXPECT_LT(sum.moment.norm(), 1e-10 * 0.07 * expected.norm());  // Newton's inversion of the mapping
  }
}

// Uniform pressure p leaves the strain -p/(3K) I in any shape, whatever the mesh's boundary error: what is left is
// rounding to degree 3 of seven blocks and, beyond, the quadrature of curved cells, which falls as they are split.
TEST(Pressure, OnABallIsHydrostatic) {
  const double p = 1e3, K = 2e4 / (3 * (1 - 2 * 0.3));
  const auto error = [&](const Resolution& resolution) {
    Scene scene = one_body(sphere, {2e4, 0.3, 1100}, resolution);
    testing::load(scene, "surface", Vector3d::Zero(), p);
    const auto answer = testing::static_answer(scene);
    const Vector3d volumetric = Vector3d::Constant(-p / (3 * K));
    const double strain = std::max((answer.strain.topRows(3).colwise() - volumetric).cwiseAbs().maxCoeff(),
                                   answer.strain.bottomRows(3).cwiseAbs().maxCoeff());
    const Matrix3Xd expected = -p / (3 * K) * answer.points;
    EXPECT_LT((answer.displacement - expected).cwiseAbs().maxCoeff(), 2 * 0.07 * strain + 1e-12);
    return strain * 3 * K / p;
  };
  for (const Resolution& resolution : {Resolution{1, {1}}, Resolution{1, {2}}, Resolution{2, {1}}, Resolution{3, {1}}})
    EXPECT_LT(error(resolution), 1e-9) << to_string(resolution);
  const double quartic = error({4, {1}});
  EXPECT_LT(quartic, 2e-3);
  EXPECT_LT(error({4, {2}}), 0.1 * quartic);
}

TEST(Pressure, RefusesADiscOffItsFace) {
  const Discretisation d(sphere, {1, {1}});
  EXPECT_THROW(patch_load(d, {"surface", Disc{{5, 0, 0}, 0.01}}, Vector3d::Zero(), 1), std::invalid_argument);
}

}  // namespace
}  // namespace mb::fem
