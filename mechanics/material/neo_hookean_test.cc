#include "mechanics/material/neo_hookean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mb {
namespace {

using Eigen::Matrix3d;

const Material rubber{2.3e4, 0.41, 1100};
const Lame c = lame(rubber);
constexpr double scale = 2.3e4;  // [Pa]

Matrix3d random_matrix(std::mt19937& random, double size) {
  std::normal_distribution<double> normal;
  return Matrix3d::NullaryExpr([&] { return size * normal(random); });
}
// Volume changes by up to half, shear by up to a half.
Matrix3d random_deformation(std::mt19937& random) {
  for (;;) {
    const Matrix3d F = Matrix3d::Identity() + random_matrix(random, 0.25);
    if (F.determinant() > 0.3) return F;
  }
}
Matrix3d random_rotation(std::mt19937& random) {
  return Eigen::AngleAxisd(2.1, random_matrix(random, 1).col(0).normalized()).toRotationMatrix();
}
Deformation at(const Matrix3d& F) { return deformation(F).value(); }

TEST(NeoHookean, LameConstantsAreHookes) {
  const Matrix6d D = elasticity_matrix(rubber);
  EXPECT_NEAR(c.lambda, D(0, 1), 1e-12 * scale);  // rounding
  EXPECT_NEAR(c.mu, D(3, 3), 1e-12 * scale);
  Material wood = rubber;
  wood.orthotropy = Orthotropy{{1e4, 1e4, 1e4}, {0.3, 0.3, 0.3}, {4e3, 4e3, 4e3}};
  EXPECT_THROW(lame(wood), std::invalid_argument);
}

TEST(NeoHookean, RestHasNeitherEnergyNorStress) {
  EXPECT_EQ(neo_hookean::energy(c, at(Matrix3d::Identity())), 0);
  EXPECT_EQ(neo_hookean::stress(c, at(Matrix3d::Identity())).norm(), 0);
}

TEST(NeoHookean, LinearisesToHookesLaw) {
  std::mt19937 random(1);
  const Matrix3d H = random_matrix(random, 1), eps = 0.5 * (H + H.transpose());
  const Matrix3d sigma = c.lambda * eps.trace() * Matrix3d::Identity() + 2 * c.mu * eps;
  const Matrix9d A = neo_hookean::tangent(c, at(Matrix3d::Identity()));
  EXPECT_LT((A * H.reshaped() - sigma.reshaped()).norm(), 1e-14 * sigma.norm());  // rounding
  const auto off = [&](double h) {
    return (neo_hookean::stress(c, at(Matrix3d::Identity() + h * H)) / h - sigma).norm() / sigma.norm();
  };
  EXPECT_NEAR(std::log10(off(1e-3) / off(1e-4)), 1, 0.05);  // the remainder is of second order in h
}

// Central differences with step h: h^2 of truncation and 1e-16/h of rounding.
TEST(NeoHookean, StressAndTangentAreDerivatives) {
  std::mt19937 random(2);
  constexpr double h = 1e-5;
  for (int trial = 0; trial < 20; ++trial) {
    const Matrix3d F = random_deformation(random);
    const Matrix3d P = neo_hookean::stress(c, at(F));
    const Matrix9d A = neo_hookean::tangent(c, at(F));
    EXPECT_LT((A - A.transpose()).norm(), 1e-13 * A.norm());  // major symmetry
    for (int k = 0; k < 9; ++k) {
      Matrix3d plus = F, minus = F;
      plus.reshaped()[k] += h, minus.reshaped()[k] -= h;
      const double slope = (neo_hookean::energy(c, at(plus)) - neo_hookean::energy(c, at(minus))) / (2 * h);
      EXPECT_NEAR(slope, P.reshaped()[k], 1e-7 * scale);
      const Matrix3d column = (neo_hookean::stress(c, at(plus)) - neo_hookean::stress(c, at(minus))) / (2 * h);
      EXPECT_LT((column.reshaped() - A.col(k)).norm(), 1e-7 * A.norm());
    }
  }
}

TEST(NeoHookean, FramesDoNotMatter) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Matrix3d F = random_deformation(random), rate = random_matrix(random, 30), Q = random_rotation(random);
    const Matrix3d P = neo_hookean::stress(c, at(F));
    EXPECT_NEAR(neo_hookean::energy(c, at(Q * F)), neo_hookean::energy(c, at(F)), 1e-13 * scale);  // rounding
    EXPECT_LT((neo_hookean::stress(c, at(Q * F)) - Q * P).norm(), 1e-13 * scale);
    EXPECT_LT((P * F.transpose() - F * P.transpose()).norm(), 1e-13 * scale);  // Kirchhoff stress is symmetric
    // Seen from a frame that turns, x* = Q x, F*' = Q F' + Omega Q F.
    Matrix3d Omega = random_matrix(random, 40);
    Omega -= Matrix3d(Omega.transpose());
    const Matrix3d viscous = neo_hookean::viscous_stress(c, 1e-3, F, rate);
    const Matrix3d seen = neo_hookean::viscous_stress(c, 1e-3, Q * F, Q * rate + Omega * Q * F);
    EXPECT_LT((seen - Q * viscous).norm(), 1e-13 * viscous.norm() * 10);
    EXPECT_GT((viscous.cwiseProduct(rate)).sum(), 0);
    EXPECT_LT(neo_hookean::viscous_stress(c, 1e-3, F, Omega * F).norm(), 1e-12 * viscous.norm());
  }
}

// A bar pulled along x by l, free across: mu (l_t^2 - 1) + lambda ln J = 0 with J = l l_t^2, and the nominal stress
// P = mu (l - 1/l) + lambda ln J / l = mu (l - l_t^2/l).
TEST(NeoHookean, UniaxialStressByHand) {
  for (const double l : {0.4, 0.8, 1.3, 2.5}) {
    double s = 1;  // l_t^2
    for (int i = 0; i < 60; ++i) s -= (c.mu * (s - 1) + c.lambda * std::log(l * s)) / (c.mu + c.lambda / s);
    const Matrix3d P = neo_hookean::stress(c, at(Vector3d(l, std::sqrt(s), std::sqrt(s)).asDiagonal()));
    EXPECT_NEAR(P(0, 0), c.mu * (l - s / l), 1e-12 * scale);
    EXPECT_NEAR(P(1, 1), 0, 1e-12 * scale);
    EXPECT_NEAR(P(2, 2), 0, 1e-12 * scale);
  }
  // nearly at rest Young's modulus is left
  const double l = 1 + 1e-6, s = 1 - 2 * rubber.poissons_ratio * 1e-6;
  EXPECT_NEAR(c.mu * (l - s / l), rubber.youngs_modulus * 1e-6, 1e-5 * scale * 1e-6);
}

TEST(NeoHookean, InversionIsSeen) {
  EXPECT_FALSE(deformation(Vector3d(1, -1, 1).asDiagonal()));
  EXPECT_FALSE(deformation(Vector3d(1, 0, 1).asDiagonal()));
  EXPECT_FALSE(deformation(Vector3d(1, std::nan(""), 1).asDiagonal()));
  EXPECT_TRUE(deformation(Vector3d(-1, -1, 1).asDiagonal()));  // half a turn
}

}  // namespace
}  // namespace mb
