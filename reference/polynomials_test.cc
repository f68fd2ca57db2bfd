#include <gtest/gtest.h>

#include "mechanics/algebra/dense_eigen.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

using testing::face;
using testing::support;
using K = Support::Kind;

const Material rubber{2e4, 0.45, 1100};
const Shape box = Box{{0.3, 0.2, 0.5}}, cylinder = Cylinder{0.05, 0.2};

std::shared_ptr<const FullModel> model(const Shape& shape, const Resolution& resolution,
                                       const std::vector<Support>& supports = {}) {
  Scene scene = one_body(shape, rubber, resolution);
  scene.bodies[0].supports = supports;
  return full_model(scene, scene.bodies[0], resolution);
}

TEST(Polynomials, CountWhatTheSupportsAdmit) {
  const auto counts = [](const FullModel& full) {
    return std::array{full.polynomials(0).cols(), full.polynomials(1).cols(), full.polynomials(2).cols()};
  };
  using Counts = std::array<Index, 3>;
  const Resolution fine{2, {1, 2}};
  const Patch bottom = face("z-min"), top = face("z-max");
  EXPECT_EQ(counts(*model(cylinder, fine)), (Counts{3, 12, 30}));
  EXPECT_EQ(counts(*model(cylinder, {2, {0, 1}})), (Counts{3, 12, 30}));
  EXPECT_EQ(counts(*model(Sphere{0.07}, {2, {1}})), (Counts{3, 12, 30}));
  // z + l/2 times polynomials of one degree less.
  EXPECT_EQ(counts(*model(cylinder, fine, {support(K::fixed, bottom)})), (Counts{0, 3, 12}));
  // Across: as free; along the normal as if fixed.
  EXPECT_EQ(counts(*model(cylinder, fine, {support(K::sliding, bottom)})), (Counts{2, 9, 24}));
  // Across: z^2 - l^2/4 alone; along: all.
  EXPECT_EQ(counts(*model(cylinder, fine, {support(K::diaphragm, bottom), support(K::diaphragm, top)})),
            (Counts{1, 4, 12}));
  EXPECT_EQ(counts(*model(cylinder, fine, {support(K::mean, bottom)})), (Counts{2, 11, 29}));
  // Eight nodes tell eight monomials apart: of x^2, y^2, z^2 and 1 on a cube's corners only one.
  EXPECT_EQ(counts(*model(box, {1, {1, 1, 1}})), (Counts{3, 12, 21}));
}

double largest_outside(const MatrixXd& basis, const MatrixXd& fields) {
  const MatrixXd rest = fields - basis * basis.colPivHouseholderQr().solve(fields);
  return rest.colwise().norm().maxCoeff() / fields.colwise().norm().maxCoeff();
}

TEST(Polynomials, SpanRigidModesAndLinearStrain) {
  for (const auto& full : {model(cylinder, {2, {1, 2}}), model(cylinder, {4, {0, 1}}), model(box, {1, {2, 2, 2}})}) {
    const MatrixXd P1 = full->polynomials(1), P2 = full->polynomials(2);
    EXPECT_LT(largest_outside(P1, full->system().R), 1e-12);
    EXPECT_LT(largest_outside(P2, P1), 1e-12);
    EXPECT_LT(largest_outside(full->polynomials(1), full->polynomials(0)), 1e-12);
    // Each column of P1 has the same strain everywhere, the twelve together all six strains.
    const Quadrature points = volume_quadrature(full->n_cells() == 8 ? box : cylinder);
    const MatrixXd strain = full->strain_at(points.points) * P1;
    MatrixXd spread = strain;
    for (Index p = 0; p < points.weights.size(); ++p) spread.middleRows(6 * p, 6) -= strain.topRows(6);
    EXPECT_LT(spread.cwiseAbs().maxCoeff(), 1e-9 * strain.cwiseAbs().maxCoeff());
    EXPECT_EQ(strain.topRows(6).colPivHouseholderQr().rank(), 6);
  }
}

// Quadratics on a quadratic mesh of straight cells are exact everywhere: their strains are linear.
TEST(Polynomials, OfDegreeTwoAreQuadraticBetweenTheNodes) {
  const auto full = model(box, {2, {1, 2, 1}});
  const Matrix3Xd x = volume_quadrature(box).points;
  MatrixXd monomials(x.cols(), 10);
  const auto X = x.row(0).transpose().array(), Y = x.row(1).transpose().array(), Z = x.row(2).transpose().array();
  monomials << VectorXd::Ones(x.cols()), X, Y, Z, X * X, Y * Y, Z * Z, Y * Z, X * Z, X * Y;
  const MatrixXd at = full->displacement_at(x) * full->polynomials(2);
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(largest_outside(monomials, at(Eigen::seq(i, Eigen::last, 3), Eigen::all)), 1e-11);
}

TEST(Polynomials, AreIndependentAndOfOneSizeAndHoldTheSupports) {
  const auto full = model(cylinder, {3, {1, 2}}, {support(K::fixed, face("z-min"))});
  const MatrixXd P = full->polynomials(2);
  const VectorXd sigma = singular_values(P);
  EXPECT_LT(sigma[0], 1.0 + 1e-12);  // orthonormal over all nodes, the held ones being zero
  EXPECT_GT(sigma[11], 1.0 - 1e-8);
  const Vector3d base(0.01, 0.02, -0.1), above(0.01, 0.02, 0.05);
  EXPECT_LT((full->displacement_at(base) * P).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GT((full->displacement_at(above) * P).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Polynomials, RefuseANegativeDegree) {
  EXPECT_THROW(model(box, {1, {1, 1, 1}})->polynomials(-1), std::invalid_argument);
}

}  // namespace
}  // namespace mb
