#include "mechanics/rigid/elliptic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <vector>

#include "mechanics/types.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

const std::vector<double> parameters = {1, 1 - 1e-15, 0.9, 0.5, 0.1, 0.03, 0.0294, 0.02, 1e-3, 1e-8, 1e-20, 1e-100};

double K(double m1) { return 0.5 * pi / JacobiFunctions(m1).mean(); }

TEST(JacobiFunctions, SatisfyTheirIdentities) {
  for (const double m1 : parameters) {
    const JacobiFunctions f(m1);
    for (double x = -1; x <= 1; x += 0.03125) {
      const auto [sn, cn, dn] = f.at(x * K(m1));
      EXPECT_NEAR(sn * sn + cn * cn, 1, 1e-15);
      EXPECT_NEAR(dn * dn, m1 + (1 - m1) * cn * cn, 2e-15 * dn * dn) << m1 << ' ' << x;  // relative: terms > 0
    }
  }
}

// sn(u + v) from the values at u and v (DLMF 22.8.1), with the quarter period left behind by u + v.
TEST(JacobiFunctions, SatisfyTheAdditionTheorem) {
  for (const double m1 : {1.0, 0.7, 0.3, 0.05, 1e-3}) {
    const JacobiFunctions f(m1);
    for (double x = -0.9; x < 1; x += 0.2)
      for (double y = -0.9; y < 1; y += 0.3) {
        const Jacobi u = f.at(x * K(m1)), v = f.at(y * K(m1)), sum = f.at((x + y) * K(m1));
        const double denominator = 1 - (1 - m1) * u.sn * u.sn * v.sn * v.sn;
        EXPECT_NEAR(sum.sn, (u.sn * v.cn * v.dn + v.sn * u.cn * u.dn) / denominator, 3e-15 / denominator);
        EXPECT_NEAR(sum.cn, (u.cn * v.cn - u.sn * u.dn * v.sn * v.dn) / denominator, 3e-15 / denominator);
      }
  }
}

TEST(JacobiFunctions, AreElementaryAtBothEnds) {
  const JacobiFunctions circular(1), hyperbolic(0);
  for (double u = -1.5; u < 1.6; u += 0.1) {
    EXPECT_NEAR(circular.at(u).sn, std::sin(u), 1e-15);
    EXPECT_NEAR(circular.at(u).cn, std::cos(u), 1e-15);
    EXPECT_EQ(circular.at(u).dn, 1);
    EXPECT_NEAR(hyperbolic.at(20 * u).sn, std::tanh(20 * u), 1e-15);
    const double sech = 1 / std::cosh(20 * u), near = JacobiFunctions(1e-40).at(20 * u).dn;
    EXPECT_NEAR(hyperbolic.at(20 * u).dn, sech, 1e-15 * sech);
    EXPECT_NEAR(near, sech, 1e-13 * sech);  // dn keeps its relative accuracy down to sech 32 = 3e-14
  }
  EXPECT_EQ(hyperbolic.at(1e200).cn, 0);
  EXPECT_EQ(circular.at(1e-300).sn, 1e-300);
}

TEST(JacobiFunctionsVerification, HalfAQuarterPeriod) {  // DLMF table 22.5.2
  for (const double m1 : parameters) {
    const Jacobi j = JacobiFunctions(m1).at(0.5 * K(m1));
    const double k1 = std::sqrt(m1);
    EXPECT_NEAR(j.sn, 1 / std::sqrt(1 + k1), 1e-15);
    EXPECT_NEAR(j.cn, std::sqrt(k1 / (1 + k1)), 4e-16 * (1 + K(m1)) * j.cn);  // K is rounded, cn' / cn is about 1
    EXPECT_NEAR(j.dn, std::sqrt(k1), 4e-16 * (1 + K(m1)) * j.dn);
  }
}

TEST(CarlsonVerification, PublishedValues) {  // Carlson 1995, Numerical Algorithms 10, 13-26, sect. 3
  EXPECT_NEAR(carlson_rf(1, 2, 0), 1.3110287771461, 5e-14);
  EXPECT_NEAR(carlson_rf(0.5, 1, 0), 1.8540746773014, 5e-14);
  EXPECT_NEAR(carlson_rf(2, 3, 4), 0.58408284167715, 5e-15);
  const Vector3d off((carlson_rf(1, 2, 0) - 1.3110287771461) / 1e-13, (carlson_rf(0.5, 1, 0) - 1.8540746773014) / 1e-13,
                     (carlson_rf(2, 3, 4) - 0.58408284167715) / 1e-14);
  testing::expect_verified(
      {.quantity = "Carlson's R_F at (1, 2, 0), (1/2, 1, 0) and (2, 3, 4), in units of the last printed digit",
       .reference = "published",
       .source = "Carlson 1995, Numerical Algorithms 10, 13-26, sect. 3",
       .uncertainty = "0.5, the digits printed",
       .tolerance = 0.5,
       .why = "Half of the last digit: R_F itself is good to some 1e-15."},
      off.cwiseAbs().maxCoeff());
}

TEST(Carlson, InvertsTheJacobiFunctions) {
  for (const double m1 : parameters) {
    const JacobiFunctions f(m1);
    EXPECT_NEAR(carlson_rf(0, m1, 1), K(m1), 1e-15 * K(m1));
    for (double x = -0.99; x < 1; x += 0.09) {
      const auto [sn, cn, dn] = f.at(x * K(m1));
      EXPECT_NEAR(sn * carlson_rf(cn * cn, dn * dn, 1), x * K(m1), 4e-15 * K(m1)) << m1 << ' ' << x;
    }
  }
}

TEST(Carlson, IsHomogeneousAndSymmetric) {
  EXPECT_NEAR(carlson_rf(4e100, 9e100, 2e100), 1e-50 * carlson_rf(2, 4, 9), 4e-16 * 1e-50 * carlson_rf(2, 4, 9));
  EXPECT_EQ(carlson_rf(9, 9, 9), 1.0 / 3);
}

// The trapezoidal rule converges exponentially: 256 points are exact to rounding where the integrand varies over 1/20
// of the period.
TEST(MeanOfThirdKindVerification, AgreesWithQuadrature) {
  for (const double m1 : {1.0, 0.8, 0.3, 0.05})
    for (const double r : {3.0, 1.0, 0.7, 0.2, 0.05}) {
      const JacobiFunctions f(m1);
      double sum = 0;
      for (int i = 0; i < 256; ++i) {
        const Jacobi j = f.at((i / 128.0 - 1) * K(m1));
        sum += j.sn * j.sn / (j.sn * j.sn + r * j.cn * j.cn);
      }
      EXPECT_NEAR(mean_of_third_kind(m1, r), sum / 256, 1e-14) << m1 << ' ' << r;
    }
}

TEST(MeanOfThirdKind, HasItsLimits) {
  EXPECT_EQ(mean_of_third_kind(1, 1), 0.5);  // of sin^2
  for (const double r : {1.0, 0.3, 1e-10}) {
    EXPECT_NEAR(mean_of_third_kind(1, r), 1 / (1 + std::sqrt(r)), 4e-16);  // of circular functions
    EXPECT_NEAR(mean_of_third_kind(0, r), 1, 4e-16);                       // K is infinite
  }
}

// By its definition, 20 terms in long double; both series meet at m1 = 0.0294.
double theta_argument(double m, double m1, double b, double u) {
  const long double K1 = 0.5L * pi / agm(1, std::sqrt(m1)), K2 = 0.5L * pi / agm(1, std::sqrt(m));
  const std::complex<long double> z = pi / (2 * K1) * std::complex<long double>(u, b);
  std::complex<long double> sum = 1;
  for (int n = 1; n <= 20; ++n)
    sum += (n % 2 ? -2.0L : 2.0L) * std::exp(-2 * pi * n * n * K2 / K1) * std::cos(static_cast<long double>(2 * n) * z);
  return static_cast<double>(std::arg(sum));
}

TEST(ThetaArgumentVerification, AgreesWithTheDefinition) {
  for (const double m1 : {0.999, 0.5, 0.1, 0.03, 0.0294, 0.0295, 0.02, 1e-3, 1e-5})
    for (const double part : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      const double b = part * K(1 - m1);
      const ThetaArgument chi(1 - m1, m1, b);
      for (double x = -1; x <= 1; x += 0.0625)
        EXPECT_NEAR(chi.at(x * K(m1)), theta_argument(1 - m1, m1, b, x * K(m1)), 4e-15) << m1 << ' ' << part;
    }
}

TEST(ThetaArgument, VanishesWhereNothingModulates) {
  EXPECT_EQ(ThetaArgument(0, 1, 0).at(1), 0);
  EXPECT_EQ(ThetaArgument(0.5, 0.5, 0.7).at(0), 0);
  EXPECT_NEAR(ThetaArgument(0.5, 0.5, 0.7).at(K(0.5)), 0, 1e-16);
  EXPECT_NEAR(ThetaArgument(1, 0, 0.7).at(1e10), 0.35, 1e-15);  // separatrix: arctan(tanh x tan y) -> y = b/2
}

TEST(Elliptic, RefusesParametersOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double m1 : {-1e-20, 1.0000001, nan}) {
    EXPECT_THROW(JacobiFunctions{m1}, std::invalid_argument);
    EXPECT_THROW(mean_of_third_kind(m1, 0.5), std::invalid_argument);
    EXPECT_THROW(ThetaArgument(0.5, m1, 0.5), std::invalid_argument);
    EXPECT_THROW(ThetaArgument(m1, 0.5, 0.5), std::invalid_argument);
  }
  for (const double r : {0.0, -1.5, inf, nan}) EXPECT_THROW(mean_of_third_kind(0.5, r), std::invalid_argument);
  for (const double x : {-1.0, 0.0, inf, nan}) EXPECT_THROW(carlson_rf(x, 0, 1), std::invalid_argument);
  for (const double x : {-1.0, nan}) EXPECT_THROW(agm(1, x), std::invalid_argument);
  EXPECT_THROW(ThetaArgument(0.5, 0.5, nan), std::invalid_argument);
  for (const double m1 : {0.5, 0.0}) EXPECT_TRUE(std::isnan(JacobiFunctions(m1).at(nan).cn));
}

}  // namespace
}  // namespace mb
