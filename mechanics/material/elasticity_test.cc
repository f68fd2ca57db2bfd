#include "mechanics/material/elasticity.h"
#include "mechanics/algebra/dense_eigen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace mb {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

Orthotropy spruce() {  // order of magnitude of a softwood: moduli a factor 25 apart
  return {Vector3d(0.6e9, 1.1e9, 15e9), Vector3d(0.025, 0.015, 0.31), Vector3d(1.2e9, 0.9e9, 0.05e9)};
}

Material of(const Orthotropy& orthotropy) { return {orthotropy.youngs_moduli.maxCoeff(), 0.3, 450, orthotropy}; }

Orthotropy isotropic(double E, double nu) {
  return {Vector3d::Constant(E), Vector3d::Constant(nu), Vector3d::Constant(E / (2 * (1 + nu)))};
}

TEST(ElasticityTest, IsotropicModuliGiveTheIsotropicMatrix) {
  for (const double nu : {-0.9, -0.2, 0.0, 0.3, 0.499}) {
    const Material plain{210e9, nu, 7800, {}};
    const Matrix6d D = elasticity_matrix(plain),
                   D_orthotropic = elasticity_matrix({210e9, 0.1, 7800, isotropic(210e9, nu)});
    // The compliance of nu = 0.499 has a condition number of 750: twelve digits are left with room.
    EXPECT_LT((D_orthotropic - D).norm(), 1e-12 * D.norm()) << nu;
    EXPECT_NEAR(shear_wave_speed(plain), shear_wave_speed({210e9, 0.1, 7800, isotropic(210e9, nu)}), 1e-9);
  }
}

// Stress along one axis alone: that axis strains by sigma/E, the others by -nu sigma/E.
TEST(ElasticityTest, UniaxialTensionRecoversModuli) {
  const Orthotropy o = spruce();
  const Matrix6d S = elasticity_matrix(of(o)).inverse();
  const double nu_yz = o.poissons_ratios[0], nu_xz = o.poissons_ratios[1], nu_xy = o.poissons_ratios[2];
  const double tolerance = 1e-13;  // cond(D) = 300 on eps
  for (Index i = 0; i < 3; ++i) {
    const Vector6d strain = S * (2e6 * Vector6d::Unit(i));
    EXPECT_NEAR(2e6 / strain[i], o.youngs_moduli[i], tolerance * o.youngs_moduli[i]);
    const Vector6d shear = S * (2e6 * Vector6d::Unit(3 + i));
    EXPECT_NEAR(2e6 / shear[3 + i], o.shear_moduli[i], tolerance * o.shear_moduli[i]);
    EXPECT_EQ(shear.head<3>().norm(), 0);
  }
  EXPECT_NEAR(-S(1, 0) / S(0, 0), nu_xy, tolerance);
  EXPECT_NEAR(-S(2, 0) / S(0, 0), nu_xz, tolerance);
  EXPECT_NEAR(-S(2, 1) / S(1, 1), nu_yz, tolerance);
  // the reciprocal ratio: tension along z contracts x by nu_zx = nu_xz E_z/E_x
  EXPECT_NEAR(-S(0, 2) / S(2, 2), nu_xz * o.youngs_moduli[2] / o.youngs_moduli[0], tolerance);
}

TEST(ElasticityTest, MatrixIsSymmetricPositiveDefinite) {
  const Matrix6d D = elasticity_matrix(of(spruce()));
  EXPECT_EQ((D - D.transpose()).norm(), 0);
  EXPECT_GT(symmetric_eigenvalues(D)[0], 0);
}

TEST(ElasticityTest, ScalesAreTheLargestModuli) {
  const Material wood = of(spruce());
  EXPECT_EQ(shear_modulus(wood), 1.2e9);
  EXPECT_EQ(shear_wave_speed(wood), std::sqrt(1.2e9 / 450));
}

TEST(ElasticityTest, UnstableIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  std::vector<Orthotropy> unstable = {isotropic(1e9, 0.5), isotropic(1e9, 0.6), isotropic(1e9, nan)};
  for (const double modulus : {0.0, -1e9, nan, infinity}) {
    unstable.push_back(spruce());
    unstable.back().youngs_moduli[1] = modulus;
    unstable.push_back(spruce());
    unstable.back().shear_moduli[2] = modulus;
  }
  unstable.push_back(spruce());
  unstable.back().poissons_ratios[2] = 1.01 * std::sqrt(0.6 / 1.1);  // nu_xy^2 < E_x/E_y is necessary
  for (const Orthotropy& o : unstable) {
    EXPECT_FALSE(is_stable(o));
    EXPECT_THROW(elasticity_matrix({1e9, 0.3, 1e3, o}), std::invalid_argument);
  }
  EXPECT_TRUE(is_stable(spruce()));
  Orthotropy nearly = spruce();  // large ratios are not instability: nu_xy < sqrt(E_x/E_y) = 0.738
  nearly.poissons_ratios = Vector3d(0, 0, 0.737);
  EXPECT_TRUE(is_stable(nearly));
}

}  // namespace
}  // namespace mb
