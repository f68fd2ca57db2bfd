#include "mechanics/system/one_step.h"
#include "mechanics/algebra/dense_eigen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <stdexcept>

#include "mechanics/system/central_difference.h"
#include "mechanics/system/explicit_euler.h"
#include "mechanics/system/newmark.h"
#include "mechanics/system/stability.h"
#include "mechanics/system/symplectic_euler.h"

namespace mb {
namespace {

const VectorXd omega{{3, 10, 47}};
const char* const names[] = {"explicit-euler", "symplectic-euler", "central-difference", "newmark"};

CoupledModes uncoupled(const VectorXd& zeta) {
  return {VectorXd(omega.cwiseAbs2()).asDiagonal(), VectorXd(2 * zeta.cwiseProduct(omega)).asDiagonal()};
}

// A dashpot that all modes feel.
CoupledModes braked(double c) {
  const VectorXd g{{1, -0.7, 0.4}};
  return {VectorXd(omega.cwiseAbs2()).asDiagonal(), c * g * g.transpose()};
}

TEST(OneStep, OfUncoupledModesHasTheLargestOfTheirRadii) {
  for (const VectorXd& zeta : {VectorXd{{0, 0, 0}}, VectorXd{{0.3, 0.01, 0.1}}, VectorXd{{0, 2, 1e-3}}})
    for (const char* name : names)
      for (const double h : {1e-4, 0.01, 0.04, 0.1, 3.0}) {
        double largest = 0;
        for (Index i = 0; i < 3; ++i)
          largest = std::max(largest, spectral_radius(scheme(name).amplification(omega(i) * h, zeta(i))));
        EXPECT_NEAR(spectral_radius(one_step(uncoupled(zeta), name, h)), largest, 1e-10 * largest) << name << " " << h;
      }
}

TEST(OneStep, OfModesWithoutStiffnessStays) {
  const CoupledModes free{MatrixXd(VectorXd{{0, 0, 100}}.asDiagonal()), MatrixXd::Zero(3, 3)};
  for (const char* name : {"symplectic-euler", "central-difference", "newmark"})
    EXPECT_NEAR(spectral_radius(one_step(free, name, 0.1)), 1, 1e-7) << name;
}

System with_dashpot(const CoupledModes& modes) {
  System system;
  system.M = SparseMatrix(VectorXd::Ones(3).asDiagonal());
  system.K = modes.K.sparseView();
  const EigenPairs C = symmetric_eigen(modes.C);
  system.modal_damping = {C.vectors.rightCols(1), C.values.tail(1)};
  system.R.resize(3, 0);
  system.F.resize(3, 0);
  system.u0 = omega.cwiseInverse();
  system.v0 = VectorXd::Zero(3);
  return system;
}

// prod_i (x - lambda_i), from the constant on.
VectorXd characteristic_polynomial(const MatrixXd& A) {
  Eigen::VectorXcd p = Eigen::VectorXcd::Zero(A.rows() + 1);
  p(0) = 1;
  for (const std::complex<double> lambda : general_eigenvalues(A)) {
    Eigen::VectorXcd next = -lambda * p;
    next.tail(A.rows()) += p.head(A.rows());
    p = next;
  }
  return p.real();
}

// Whatever a run starts from, its places are sums of powers of the matrix' eigenvalues: its characteristic polynomial
// takes them to nothing.
TEST(OneStep, OfCoupledModesHasTheEigenvaluesThatIntegratorsStepBy) {
  using Make = std::unique_ptr<Stepper> (*)(const System&, double);
  const std::pair<const char*, Make> integrators[] = {{"explicit-euler", explicit_euler},
                                                      {"symplectic-euler", symplectic_euler},
                                                      {"central-difference", central_difference},
                                                      {"newmark", newmark}};
  const CoupledModes modes = braked(20);
  const System system = with_dashpot(modes);
  for (const auto& [name, make] : integrators)
    for (const double h : {0.01, 0.05}) {
      const VectorXd p = characteristic_polynomial(one_step(modes, name, h));
      const MatrixXd u = make(system, h)->run(h * VectorXd::LinSpaced(20, 1, 20)).u;
      for (Index first = 0; first + 7 <= 20; ++first) {
        const auto seven = u.middleCols(first, 7);
        EXPECT_LT((seven * p).norm(), 1e-12 * seven.norm() * p.norm()) << name << " " << h;
      }
      const VectorXd other = characteristic_polynomial(one_step(braked(21), name, h));
      EXPECT_GT((u.leftCols(7) * other).norm(), 1e-9 * u.leftCols(7).norm() * other.norm()) << name << " " << h;
    }
}

// Theory: 4 - 2 h C - h^2 K must be positive definite, of damping that is implicit 4 - h^2 K; average acceleration and
// what damping takes know no limit.
TEST(OneStep, ExplicitLimitsOfCoupledDampingAreThoseOfTheory) {
  for (const double c : {0.0, 20.0, 300.0}) {
    const CoupledModes modes = braked(c);
    for (const char* name : names) {
      const double limit = stable_step(modes, name);
      if (limit == 0 || std::isinf(limit)) continue;
      EXPECT_LE(spectral_radius(one_step(modes, name, 0.999 * limit)), 1 + 1e-12) << c << name;
      EXPECT_GT(spectral_radius(one_step(modes, name, 1.001 * limit)), 1 + 1e-9) << c << name;
    }
    EXPECT_EQ(stable_step(modes, "explicit-euler") == 0, c == 0);
    EXPECT_NEAR(stable_step(modes, "central-difference"), 2.0 / 47, 1e-12);
    EXPECT_EQ(stable_step(modes, "symplectic-euler") < 0.99 * 2.0 / 47, c > 0);
    EXPECT_TRUE(std::isinf(stable_step(modes, "newmark")));
    for (const double h : {1e-3, 0.1, 10.0}) EXPECT_LE(spectral_radius(one_step(modes, "newmark", h)), 1 + 1e-10) << c;
  }
}

TEST(SpectralRadius, IsThatOfTheLargestEigenvalue) {
  std::srand(7);
  for (const double scale : {1e-8, 1.0, 1e8}) {
    const MatrixXd A = scale * MatrixXd::Random(9, 9);
    const double largest = Eigen::EigenSolver<MatrixXd>(A, false).eigenvalues().cwiseAbs().maxCoeff();
    EXPECT_NEAR(spectral_radius(A), largest, 1e-13 * largest);  // some ten roundings of a condition of ten
  }
  const MatrixXd jordan{{2, 1, 0}, {0, 2, 1}, {0, 0, 2}}, nilpotent{{0, 1}, {0, 0}}, half_turn{{0, -3}, {3, 0}},
      nothing{{std::nan("")}};
  EXPECT_NEAR(spectral_radius(jordan), 2, 1e-12);
  EXPECT_EQ(spectral_radius(nilpotent), 0);
  EXPECT_NEAR(spectral_radius(half_turn), 3, 1e-14);
  EXPECT_TRUE(std::isnan(spectral_radius(nothing)));
}

TEST(OneStep, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(one_step(braked(1), "sundials", 0.1), std::invalid_argument);
  EXPECT_THROW(one_step(braked(1), "newmark", 0), std::invalid_argument);
  EXPECT_THROW(stable_step(braked(1), "sundials"), std::invalid_argument);
  EXPECT_EQ(spectral_radius(one_step({MatrixXd(0, 0), MatrixXd(0, 0)}, "newmark", 0.1)), 0);
}

}  // namespace
}  // namespace mb
