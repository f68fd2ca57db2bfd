// Bodies on meshes graded to where they will touch the floor.
#include <gtest/gtest.h>

#include "cases/scene/resolution.h"
#include "mechanics/algebra/cholesky.h"
#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/pose.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

using testing::face;
using testing::load;
using testing::static_answer;
using testing::support;
using K = Support::Kind;

const Material rubber{2e4, 0.45, 1100};
const Shape box = Box{{0.3, 0.2, 0.5}}, cylinder = Cylinder{0.05, 0.2}, sphere = Sphere{0.07};

// One body, which a floor with the outward normal n [-, body frame] awaits some way below it: touched at -n.
Scene above_floor(const Shape& shape, const Resolution& resolution, const Vector3d& n,
                  const std::vector<Support>& supports = {}) {
  Scene scene = one_body(shape, rubber, resolution);
  scene.bodies[0].supports = supports;
  const Vector3d normal = n.normalized();
  const auto turn = shortest_turn(Vector3d::UnitZ(), normal);
  scene.obstacles.push_back({"floor", {HalfSpace{}, 0, {-2 * extent(shape) * normal, turn}}});
  scene.contacts.push_back({"body", "floor", 1e6});
  return scene;
}
const Vector3d up = Vector3d::UnitZ(), towards_corner(-1, -1, 1);  // of the floor: the corner x-max y-max z-min

std::shared_ptr<const FullModel> model(const Scene& scene) {
  return full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
}

// Linear displacements u = G (x - x0) that the supports admit, under their tractions: exact but for rounding.
void expect_linear(const Scene& scene, const Eigen::Matrix3d& G, const Vector3d& x0) {
  const auto answer = static_answer(scene);
  const Matrix3Xd expected = G * (answer.points.colwise() - x0);
  EXPECT_LT((answer.displacement - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff())
      << to_string(scene.bodies[0].resolution);
}

// Hanging nodes on three held faces, on their common edges and at their common corner.
TEST(GradedSupports, SlidingFacesCarryUniaxialTension) {
  const std::vector<Support> supports = {support(K::sliding, face("x-max")), support(K::sliding, face("y-max")),
                                         support(K::sliding, face("z-min"))};
  const double sigma = 300, strain = sigma / 2e4;
  for (int degree = 1; degree <= 4; ++degree) {
    Scene scene = above_floor(box, {degree, {1, 1, 3}, degree < 3 ? 3 : 1}, towards_corner, supports);
    load(scene, "x-min", {-sigma, 0, 0});
    expect_linear(scene, Vector3d(strain, -0.45 * strain, -0.45 * strain).asDiagonal(), {0.15, 0.1, -0.25});
  }
}

// The mean's weights lie on nodes that others hang on.
TEST(GradedSupports, DiaphragmsAndAMeanCarryConfinedCompression) {
  const double strain = -0.01, D = 2e4 * (1 - 0.45) / ((1 + 0.45) * (1 - 2 * 0.45)), lambda = D * 0.45 / (1 - 0.45);
  const std::vector<Support> supports = {support(K::diaphragm, face("z-min")), support(K::diaphragm, face("z-max")),
                                         support(K::mean, face("z-min"))};
  for (int degree = 1; degree <= 4; ++degree)
    for (const Vector3d& n : {up, towards_corner}) {
      Scene scene = above_floor(box, {degree, {1, 1, 3}, degree < 3 ? 2 : 1}, n, supports);
      for (const char* side : {"x-min", "x-max", "y-min", "y-max"}) load(scene, side, {0, 0, 0}, -lambda * strain);
      load(scene, "z-max", {0, 0, D * strain});
      expect_linear(scene, Vector3d(0, 0, strain).asDiagonal(), {0, 0, -0.25});
    }
}

TEST(GradedSupports, AFixedBaseCarriesSimpleShear) {
  const double gamma = 0.02, tau = gamma * 2e4 / 2.9;
  Eigen::Matrix3d G = Eigen::Matrix3d::Zero();
  G(0, 2) = gamma;
  for (const Vector3d& n : {up, towards_corner, Vector3d(0, 1, 0)}) {
    Scene scene = above_floor(box, {2, {1, 2, 2}, 2}, n, {support(K::fixed, face("z-min"))});
    load(scene, "z-max", {tau, 0, 0});
    load(scene, "x-max", {0, 0, tau});
    load(scene, "x-min", {0, 0, -tau});
    expect_linear(scene, G, {0, 0, -0.25});
  }
}

TEST(GradedSupports, LeaveTheRigidMotionsTheyDoNotHold) {
  const auto free_motions = [](const Shape& shape, const Resolution& resolution, const std::vector<Support>& supports) {
    const auto full = model(above_floor(shape, resolution, {1, 0, 3}, supports));
    const System& s = full->system();
    EXPECT_LE((s.K * s.R).norm(), 1e-10 * s.K.norm() * s.R.norm());
    return s.R.cols();
  };
  const Resolution disc{2, {1, 2}, 2}, bricks{1, {2, 2, 3}, 2};
  const Patch bottom = face("z-min"), top = face("z-max"), corner{"z-min", Disc{{-0.03, 0, -0.1}, 0.02}};
  EXPECT_EQ(free_motions(cylinder, disc, {}), 6);
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::fixed, bottom)}), 0);
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::sliding, bottom)}), 3);
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::mean, bottom)}), 5);
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::mean, corner), support(K::mean, top)}), 4);
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::diaphragm, bottom), support(K::mean, top)}), 2);
  EXPECT_EQ(free_motions(box, bricks, {support(K::mean, bottom), support(K::mean, top)}), 5);
  EXPECT_EQ(free_motions(box, bricks, {support(K::sliding, bottom), support(K::sliding, face("x-max"))}), 1);
}

// As many as on even meshes; on Q1 quadratics are not in the space, and hanging nodes take what their masters give.
TEST(GradedModel, AdmitsAsManyPolynomials) {
  for (int degree = 1; degree <= 2; ++degree) {
    const auto free = model(above_floor(sphere, {degree, {2}, 2}, up));
    EXPECT_EQ(free->polynomials(1).cols(), 12);
    EXPECT_EQ(free->polynomials(2).cols(), 30);
    const auto held = model(above_floor(box, {degree, {2, 1, 2}, 2}, up, {support(K::fixed, face("z-min"))}));
    EXPECT_EQ(held->polynomials(2).cols(), 12);
  }
}

// By min-max, omega of the nested spaces: even, graded, halved everywhere (straight cells, exact quadrature). The
// graded one differs from the finest by less than the even one.
TEST(GradedModel, FrequenciesLieBetweenThoseOfTheEvenMeshes) {
  const auto lowest = [](const Scene& scene) {
    const auto full = model(scene);
    const System& s = full->system();
    const VectorXd lambda = generalized_eigenvalues(MatrixXd(s.K), MatrixXd(s.M)).value();
    return VectorXd(lambda.segment(s.R.cols(), 12));
  };
  for (const auto& supports : {std::vector<Support>{}, std::vector<Support>{support(K::fixed, face("x-max"))}}) {
    const VectorXd even = lowest(above_floor(box, {1, {2, 2, 4}}, towards_corner, supports)),
                   graded = lowest(above_floor(box, {1, {2, 2, 4}, 1}, towards_corner, supports)),
                   fine = lowest(above_floor(box, {1, {4, 4, 8}}, towards_corner, supports));
    for (Index i = 0; i < fine.size(); ++i) {
      EXPECT_LT(fine[i], graded[i] * (1 + 1e-10)) << i;  // dense eigenvalues: 1e-16 of the largest, 1e3 times these
      EXPECT_LT(graded[i], even[i] * (1 + 1e-10)) << i;
    }
    EXPECT_LT((graded - fine).sum(), 0.95 * (even - fine).sum());
  }
}

// The same on a ball, whose fine mesh has another surface: within the even mesh's own error.
TEST(GradedModel, FrequenciesOfABallStayNearThoseOfAFinerMesh) {
  const auto lowest = [](const Resolution& resolution) {
    const auto full = model(above_floor(sphere, resolution, up));
    const System& s = full->system();
    const VectorXd lambda = generalized_eigenvalues(MatrixXd(s.K), MatrixXd(s.M)).value();
    return lambda.segment(6, 5).cwiseSqrt().mean();  // the quintuplet 0S2
  };
  const double even = lowest({2, {1}}), graded = lowest({2, {1}, 1}), fine = lowest({2, {2}});
  EXPECT_LT(std::abs(graded / fine - 1), std::abs(even / fine - 1));
}

TEST(GradedModel, LumpedMassIsPositiveDefinite) {
  for (int degree = 1; degree <= 3; ++degree) {
    const auto full = model(above_floor(sphere, {degree, {1}, 2}, {0.3, 0.2, 1}));
    const SparseMatrix& m = full->system().lumped_mass;
    EXPECT_GT(m.nonZeros(), m.rows());  // nodes that share what hangs on them
    EXPECT_NO_THROW(Cholesky{m});
  }
}

TEST(GradedModel, LoadsKeepTheirResultant) {
  Scene scene = above_floor(cylinder, {2, {1, 2}, 2}, {1, 0, 3});
  scene.loads.push_back({"push", Step{}, {{"body", {"z-min", Disc{{-0.03, 0.01, -0.1}, 0.015}}, {3, -5, 7}}}});
  scene.gravity = {0, 0, -9.81};
  const auto full = model(scene);
  const MatrixXd& F = full->system().F;
  ASSERT_EQ(F.cols(), 2);
  const double area = pi * 0.015 * 0.015 / 3, weight = 9.81 * 1100 * full->mesh_volume();
  for (int i = 0; i < 3; ++i) {
    const VectorXd r = full->translation(Vector3d::Unit(i));
    EXPECT_NEAR(r.dot(F.col(0)), area * Vector3d(3, -5, 7)[i], 1e-12 * area * 7);
    EXPECT_NEAR(r.dot(F.col(1)), i == 2 ? -weight : 0, 1e-11 * weight);
  }
}

// Grading refines where the body touches: what the coarse rest lacks of the volume, half of it, stays.
TEST(GradedModel, LacksTheVolumeOfItsCoarsestCells) {
  Scene scene = one_body(Sphere{0.05}, rubber, {2, {2}});
  scene.gravity = {0, 0, -9.81};
  scene.bodies[0].pose.position = {0, 0, 0.051};
  scene.obstacles.push_back({"floor", {HalfSpace{}, 0, {}}});
  scene.contacts.push_back({.body = scene.bodies[0].name, .obstacle = "floor", .stiffness = 1e8});
  const double even = missing_volume(scene, {2, {2}}), graded = missing_volume(scene, {2, {2}, 3});
  EXPECT_NEAR(even, std::abs(1 - full_model(scene, scene.bodies[0], {2, {2}})->mesh_volume() / volume(Sphere{0.05})),
              1e-14);
  EXPECT_GT(even, 1e-4);
  EXPECT_GT(graded, 0.4 * even);
  EXPECT_LT(graded, even);
  EXPECT_LT(missing_volume(scene, {3, {2}}), 0.1 * even);
}

TEST(GradedModel, SizeIsEstimatedFromAbove) {
  for (const auto& [shape, resolution] :
       std::vector<std::pair<Shape, Resolution>>{{box, {2, {3, 2, 5}, 3}},
                                                 {Box{{1, 1, 1}}, {1, {4, 4, 4}, 4}},
                                                 {Box{{1, 1, 0.1}}, {1, {4, 4, 1}, 2}},
                                                 {cylinder, {2, {1, 4}, 3}},
                                                 {sphere, {1, {2}, 5}},
                                                 {sphere, {2, {1}, 3}},
                                                 {sphere, {3, {1}, 1}}})
    for (const Vector3d& n : {up, Vector3d(0.3, 0.4, 1), towards_corner}) {
      const double estimate = n_dofs(shape, resolution);
      const auto n_free = static_cast<double>(model(above_floor(shape, resolution, n))->system().K.rows());
      EXPECT_LT(n_free, estimate) << to_string(resolution);
      EXPECT_GT(n_free, 0.2 * estimate) << to_string(resolution);  // at a corner a quarter of a face's cells lie near
    }
}

// Downward traction of weight (1 - (d/a)^2)^2 on top of a fixed cube, by a rule that is dense against every cell: its
// work on its own displacement, which Ritz approaches from below.
double compliance(const Resolution& resolution, Index& n_free) {
  const double a = 0.1;
  Scene scene = above_floor(Box{{1, 1, 1}}, resolution, -up, {support(K::fixed, face("z-min"))});
  const auto full = model(scene);
  const Rule radial = gauss_legendre(16);
  const int n_theta = 48;
  Matrix3Xd x(3, 16 * n_theta), f = Matrix3Xd::Zero(3, x.cols());
  for (Index k = 0; k < x.cols(); ++k) {
    const double s = radial.x[k / n_theta], theta = 2 * pi * static_cast<double>(k % n_theta) / n_theta;
    x.col(k) << a * std::sqrt(s) * std::cos(theta), a * std::sqrt(s) * std::sin(theta), 0.5;
    f(2, k) = -(1 - s) * (1 - s) * pi * a * a * radial.w[k / n_theta] / n_theta;
  }
  const VectorXd F = full->displacement_at(x).transpose() * f.reshaped();
  n_free = F.size();
  return F.dot(Cholesky(full->system().K).solve(F));
}

// Under a load on 3 % of the face. The exact value: degree 4, cells {2, 2, 2} and {4, 4, 4} graded three times, give
// 3.34897e-8 and 3.34944e-8.
TEST(GradedModelVerification, ALocalLoadConvergesFasterThanOnEvenMeshes) {
  const double exact = 3.3497e-8;
  const auto error = [&](const Resolution& resolution, Index& n) { return 1 - compliance(resolution, n) / exact; };
  Index n_even = 0, n_graded = 0;
  const double even = error({2, {7, 7, 7}}, n_even), graded = error({2, {2, 2, 2}, 3}, n_graded);
  EXPECT_GT(graded, 0);
  EXPECT_LT(graded, 0.25 * even) << graded << " " << even;
  EXPECT_LT(n_graded, n_even);
}

TEST(GradedModel, TakesAMeshOfEveryBodyUngradedWhereNothingTouches) {
  Scene scene = above_floor(sphere, {1, {1}}, up);
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name = "aloof";
  const Resolution graded{.degree = 1, .cells = {2}, .graded = 2, .others = {{1, {2}, 2}}};
  const Model both = build_model(std::make_shared<Scene>(scene), &graded);
  EXPECT_GT(both.bodies[0].full->n_cells(), 56);
  EXPECT_EQ(both.bodies[1].full->n_cells(), 56);
  EXPECT_THROW(full_model(scene, scene.bodies[1], graded), std::invalid_argument);
  const Resolution of_one{1, {2}, 2};
  EXPECT_THROW(build_model(std::make_shared<Scene>(scene), &of_one), std::invalid_argument);
}

}  // namespace
}  // namespace mb
