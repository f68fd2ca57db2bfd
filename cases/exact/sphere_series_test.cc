#include "cases/exact/sphere_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mechanics/algebra/worse_test.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr double ratios[] = {-0.9, -0.3, 0.0, 0.3, 0.5};

// Lur'e's two solutions with coefficients solved for, R = E = 1.
TEST(SphereSeriesVerification, SolvesLuresSystem) {
  double worst = 0;
  for (const double nu : ratios)
    for (int n = 2; n <= 40; ++n) {
      const double G = 1 / (2 * (1 + nu));
      Eigen::Matrix2d stress, displacement;  // of A r^(n+1), B r^(n-1)
      stress << (n + 1) * (n * n - n - 2 - 2 * nu), n * (n - 1), n * n + 2 * n - 1 + 2 * nu, n - 1;
      displacement << (n + 1) * (n - 2 + 4 * nu), n, n + 5 - 4 * nu, 1;
      const Eigen::Matrix2d expected = displacement * (2 * G * stress).inverse();
      // the determinant cancels by n/2 there, the product by n/4
      const double off = (surface_compliance(n, nu) - expected).norm();
      EXPECT_LT(off, 1e-15 * n * n * expected.norm()) << nu << " " << n;
      worst = worse(worst, off / (n * n * expected.norm()));
    }
  testing::expect_verified(
      {.quantity =
           "compliance of a sphere's surface to tractions of orders n = 2 to 40, nu from -0.9 to 0.5, Frobenius "
           "norm, relative and over n^2",
       .reference = "second route",
       .source = "Lur'e 1964, ch. 6: the system of his two constants, solved in numbers",
       .uncertainty = "rounding, up to n^2/8 times as much",
       .tolerance = 1e-15,
       .why = "Both are exact but for rounding: the system's determinant cancels by n/2, its product by n/4."},
      worst);
}

TEST(SphereSeriesVerification, IsReciprocalAndPositive) {
  for (const double nu : ratios)
    for (const int n : {1, 2, 3, 10, 1000, 300000}) {
      const Eigen::Matrix2d C = surface_compliance(n, nu);
      EXPECT_NEAR(C(0, 1), n * (n + 1.0) * C(1, 0), 1e-14 * std::abs(C(0, 1))) << nu << " " << n;
      EXPECT_TRUE(n == 1 || C.determinant() > 0) << nu << " " << n;  // n = 1 moves the centre of mass besides
    }
}

// Uniform tension e_z e_z: t_0 = 1/3, t_2 = 2/3, s_2 = 1/3 gives u = z e_z - nu (x e_x + y e_y), E = R = 1.
TEST(SphereSeriesVerification, UniformTension) {
  for (const double nu : ratios) {
    EXPECT_NEAR(surface_compliance(0, nu)(0, 0) / 3, (1 - 2 * nu) / 3, 1e-15);
    const Eigen::Vector2d u = surface_compliance(2, nu) * Eigen::Vector2d(2.0 / 3, 1.0 / 3);
    EXPECT_NEAR(u[0], 2 * (1 + nu) / 3, 1e-15);
    EXPECT_NEAR(u[1], (1 + nu) / 3, 1e-15);
  }
}

// Stress z I, floating in a fluid: u = (1 - 2nu) (z r - r^2 e_z/2) less its mean over the ball, -1/10 (1 - 2nu) e_z.
// And stress s_xz = s_zx = x, s_yz = s_zy = y, a body force -2 e_z: u_z = (1 + nu) (x^2 + y^2), u_x = u_y = 0, whose
// traction is z (x, y, 0) + (x^2 + y^2) e_z, of orders 1 and 3.
TEST(SphereSeriesVerification, AcceleratedSpheres) {
  for (const double nu : ratios) {
    const Eigen::Vector2d u = surface_compliance(1, nu) * Eigen::Vector2d(1, 0);
    EXPECT_NEAR(u[0], (1 - 2 * nu) * 0.6, 1e-15);
    EXPECT_NEAR(u[1], (1 - 2 * nu) * -0.4, 1e-15);
    // t_r = 2 cos sin^2 = 4/5 (P_1 - P_3),   t_theta = sin (2 cos^2 - 1) = 3/5 dP_1 - 4/15 dP_3
    const Eigen::Vector2d one = surface_compliance(1, nu) * Eigen::Vector2d(0.8, 0.6);
    const Eigen::Vector2d three = surface_compliance(3, nu) * Eigen::Vector2d(-0.8, -4.0 / 15);
    for (const double theta : {0.3, 1.1, 2.5}) {
      const double x = std::cos(theta), y = std::sin(theta), P_3 = x * (5 * x * x - 3) / 2;
      const double d_1 = -y, d_3 = -1.5 * y * (5 * x * x - 1), u_z = (1 + nu) * (y * y - 0.4);
      EXPECT_NEAR(one[0] * x + three[0] * P_3, u_z * x, 1e-15 * 4);
      EXPECT_NEAR(one[1] * d_1 + three[1] * d_3, -u_z * y, 1e-15 * 4);
    }
  }
}

// The sum rho by brute force; its tail after N terms falls as 1/N.
TEST(SphereSeriesTest, SmallContactSumsItsSeries) {
  for (const double nu : ratios) {
    const double soft = 1 - 2 * nu;
    double rho = 0;
    for (int n = 0; n < 400000; ++n)
      rho += (2.0 * n + 1) * surface_compliance(n, nu)(0, 0) / (1 + nu) - 4 * (1 - nu) - 4 * soft * soft / (2 * n + 1);
    const SmallContact round = small_contact(nu, PressureAlong::sphere_normal),
                       flat = small_contact(nu, PressureAlong::plane_normal);
    const double scale = 3 * pi * (1 - nu);
    EXPECT_NEAR(round.constant * scale - 2 * soft * soft * (std::log(2.0) + 19.0 / 12), rho, 1e-3) << nu;
    EXPECT_NEAR((round.constant - flat.constant) * scale, 2 * soft, 1e-14);
    EXPECT_EQ(round.logarithm, flat.logarithm);
  }
}

TEST(SphereSeriesTest, RefusesBadInput) {
  for (const double bad : {-1.0, 0.51, std::nan("")}) {
    EXPECT_THROW(surface_compliance(3, bad), std::invalid_argument);
    EXPECT_THROW(small_contact(bad, PressureAlong::plane_normal), std::invalid_argument);
  }
  EXPECT_THROW(surface_compliance(-1, 0.3), std::invalid_argument);
}

}  // namespace
}  // namespace mb
