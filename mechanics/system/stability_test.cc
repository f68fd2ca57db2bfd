#include "mechanics/system/stability.h"
#include "mechanics/algebra/dense_eigen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "mechanics/system/central_difference.h"
#include "mechanics/system/explicit_euler.h"
#include "mechanics/system/newmark.h"
#include "mechanics/system/symplectic_euler.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

struct Row {
  std::string method;
  double zeta, formula, numeric;
};

// method may be quoted, with commas inside; below a comment and the heading.
std::vector<Row> table() {
  std::ifstream file(MB_SOURCE_DIR "/cases/exact/tables/stability_limits.csv");
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.starts_with("method")) continue;
    const bool is_quoted = line[0] == '"';
    const size_t end = is_quoted ? line.find('"', 1) : line.find(',');
    std::stringstream numbers(line.substr(end + (is_quoted ? 2 : 1)));
    Row row{is_quoted ? line.substr(1, end - 1) : line.substr(0, end), 0, 0, 0};
    for (double* value : {&row.zeta, &row.formula, &row.numeric}) {
      std::string cell;
      std::getline(numbers, cell, ',');
      *value = std::strtod(cell.c_str(), nullptr);
    }
    rows.push_back(row);
  }
  return rows;
}

const std::map<std::string, std::string> name_of = {
    {"explicit Euler", "explicit-euler"},
    {"symplectic Euler, explicit damping", "symplectic-euler"},
    {"symplectic Euler, implicit damping", "symplectic-euler, implicit damping"},
    {"central difference, C implicit (u_{n+1}-u_{n-1})/2h", "central-difference"},
    {"leap-frog, damping lagged v_{n-1/2}", "central-difference, lagged damping"},
    {"Newmark (0.0,0.5)", "newmark (0, 1/2)"},
    {"Newmark (0.08333333333333333,0.5)", "newmark (1/12, 1/2)"},
    {"Newmark (0.16666666666666666,0.5)", "newmark (1/6, 1/2)"},
    {"Newmark (0.25,0.5)", "newmark"},
    {"Newmark (0.0,0.6)", "newmark (0, 0.6)"},
    {"Newmark (0.1,0.6)", "newmark (0.1, 0.6)"},
    {"Newmark (0.3025,0.6)", "newmark (0.3025, 0.6)"},
    {"RK2", "rk2"},
    {"RK3", "rk3"},
    {"RK4", "rk4"}};

// The one row whose number is that of a threshold: 1 + (omega h)^4/8 passes 1 + 1e-7 at 0.03, but exceeds 1 everywhere.
bool is_undamped_rk2(const Row& row) { return row.method == "RK2" && row.zeta == 0; }

TEST(StabilityVerification, LimitsOfTheTable) {
  const auto rows = table();
  ASSERT_EQ(rows.size(), 90u);
  double worst = 0;
  for (const Row& row : rows) {
    const double expected = is_undamped_rk2(row) ? 0 : row.numeric;
    const double limit = stable_omega_h(scheme(name_of.at(row.method)), row.zeta);
    if (expected == 0 || std::isinf(expected)) {
      EXPECT_EQ(limit, expected) << row.method << ", zeta " << row.zeta;
      continue;
    }
    EXPECT_NEAR(limit, expected, 1e-6 * expected) << row.method << ", zeta " << row.zeta;
    worst = std::max(worst, std::abs(limit / expected - 1));
  }
  testing::expect_verified(
      {.quantity = "largest stable omega dt of 15 schemes of time integration at 6 damping ratios, where it is finite "
                   "and not 0",
       .reference = "table",
       .source = "bisection on the spectral radius in another program: stability_limits.csv",
       .uncertainty = "5e-8 absolute, half the table's seventh decimal; both bisections end at 1e-9",
       .tolerance = 1e-6,
       .why = "Half a decimal is 1e-7 of all limits but 0.04 and 0.2, which the table holds exactly."},
      worst);
}

// On both sides at a thousandth, by the eigenvalues themselves.
TEST(StabilityVerification, SpectralRadiusCrossesOneAtTheLimitsOfTheTable) {
  for (const Row& row : table()) {
    const Scheme& s = scheme(name_of.at(row.method));
    const auto excess = [&](double omega_h) { return spectral_radius(s.amplification(omega_h, row.zeta)) - 1; };
    if (std::isinf(row.numeric)) {
      for (const double omega_h : {1e-6, 1e-3, 0.1, 3.0, 1e3, 1e6})
        EXPECT_LE(excess(omega_h), 1e-12) << row.method << ", zeta " << row.zeta << ", " << omega_h;
    } else if (row.numeric == 0 || is_undamped_rk2(row)) {
      for (const double omega_h : {0.01, 0.1, 1.0}) EXPECT_GT(excess(omega_h), 1e-12) << row.method << omega_h;
    } else {
      EXPECT_LE(excess(0.999 * row.numeric), 1e-12) << row.method << ", zeta " << row.zeta;
      EXPECT_GT(excess(1.001 * row.numeric), 1e-12) << row.method << ", zeta " << row.zeta;
    }
  }
}

TEST(StabilityVerification, FormulasOfTheTable) {
  for (const Row& row : table()) {
    const double formula = scheme(name_of.at(row.method)).formula(row.zeta);
    if (std::isnan(row.formula))
      EXPECT_TRUE(std::isnan(formula)) << row.method << ", zeta " << row.zeta;
    else if (std::isinf(row.formula))
      EXPECT_EQ(formula, row.formula);
    else
      EXPECT_NEAR(formula, row.formula, 1e-9) << row.method << ", zeta " << row.zeta;
  }
}

TEST(Stability, FormulaAndBisectionAgreeAtAnyRatio) {
  for (const Scheme& s : schemes())
    for (const double zeta : {0.0, 1e-7, 1e-4, 0.03, 0.7, 1.0, 1.3, 10.0}) {
      const double formula = s.formula(zeta), limit = stable_omega_h(s, zeta);
      if (std::isnan(formula)) continue;
      if (std::isinf(formula) || formula == 0)
        EXPECT_EQ(limit, formula) << s.name << ", zeta " << zeta;
      else
        EXPECT_NEAR(limit, formula, 1e-6 * formula) << s.name << ", zeta " << zeta;
    }
}

TEST(Stability, EverySchemeApproximatesTheOscillator) {
  for (const Scheme& s : schemes())
    for (const double zeta : {0.0, 0.3}) {
      const double x = 1e-4;  // exp of the oscillator's matrix over one step, to first order
      const Matrix2d exact = (Matrix2d() << 1, 1, -x * x, 1 - 2 * zeta * x).finished();
      const Eigen::Vector2cd a = general_eigenvalues(s.amplification(x, zeta)), b = general_eigenvalues(exact);
      EXPECT_LT(std::min((a - b).norm(), (a - b.reverse()).norm()), 2 * x * x) << s.name;
      EXPECT_FALSE(s.formula_text.empty() || s.source.empty()) << s.name;
    }
}

TEST(Stability, SpectralRadiusIsThatOfTheEigenvalues) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const VectorXd entries = VectorXd::NullaryExpr(
        4, [&](Index i) { return std::sin(1.7 * seed + 5.3 * static_cast<double>(i) * (seed + 1)); });
    const Matrix2d A = Eigen::Map<const Matrix2d>(entries.data());
    EXPECT_NEAR(spectral_radius(A), general_eigenvalues(A).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(Stability, RefusesBadInput) {
  try {
    scheme("explicit-eular");
    ADD_FAILURE() << "accepted";
  } catch (const std::out_of_range& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("explicit-eular"));
  }
  for (const double zeta : {-0.1, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(stable_omega_h(schemes().front(), zeta), std::invalid_argument);
}

enum class DampedBy { mass, stiffness, mode };

// Two masses with coupled springs, so that K is not diagonal; frequencies of 1 and 3 rad/s, ratio zeta in the second
// mode, in which alone they move.
System two_masses(double zeta, DampedBy damped_by, bool is_lumped) {
  const double omega = 3, m = 2;
  const Eigen::Rotation2D<double> turn(0.6);
  const Matrix2d Phi = turn.toRotationMatrix() / std::sqrt(m);
  System s;
  s.M = MatrixXd(m * Matrix2d::Identity()).sparseView();
  s.K = MatrixXd(m * m * Phi * Eigen::Vector2d(1, omega * omega).asDiagonal() * Phi.transpose()).sparseView();
  if (is_lumped) s.lumped_mass = s.M;
  if (damped_by == DampedBy::mass) s.damping.alpha = 2 * zeta * omega;
  if (damped_by == DampedBy::stiffness) s.damping.beta = 2 * zeta / omega;
  if (damped_by == DampedBy::mode) s.modal_damping = {m * Phi, 2 * zeta * Eigen::Vector2d(1, omega)};
  s.R.resize(2, 0);
  s.F.resize(2, 0);
  s.u0 = Phi.col(1);
  s.v0 = 0 * s.u0;
  return s;
}

using Make = std::unique_ptr<Stepper> (*)(const System&, double);

// (q, h v) of the second mode after n steps, from (1, 0) and from (0, 1): the n-th power of A, up to how a scheme
// starts.
Matrix2d after(Make make, System s, double h, double n) {
  const VectorXd MPhi = s.M * s.u0, start = s.u0;
  Matrix2d power;
  for (const Index column : {0, 1}) {
    s.u0 = (column == 0 ? 1 : 0) * start;
    s.v0 = (column == 1 ? 1 / h : 0) * start;
    const States x = make(s, h)->run(VectorXd::Constant(1, n * h));
    power.col(column) << MPhi.dot(x.u.col(0)), h * MPhi.dot(x.v.col(0));
  }
  return power;
}

// The growth over the last n of 2 n steps is rho^n within 1 %, n such that rho^n is about 100 or 1/100.
void expect_growth(const std::string& name, Make make, double zeta, DampedBy damped_by, bool is_lumped, double share) {
  const Scheme& s = scheme(name);
  const double omega_h = share * stable_omega_h(s, zeta), h = omega_h / 3;
  const Matrix2d A = s.amplification(omega_h, zeta);
  const double rho = spectral_radius(A);
  const double n = std::round(std::min(2e5, std::log(100.) / std::abs(std::log(rho)) + 1));
  const System system = two_masses(zeta, damped_by, is_lumped);
  const Matrix2d once = after(make, system, h, n), twice = after(make, system, h, 2 * n);
  const bool is_oscillating = A.trace() * A.trace() < 4 * A.determinant();  // then only areas grow steadily
  const double growth =
      is_oscillating ? std::sqrt(std::abs(twice.determinant() / once.determinant())) : twice.norm() / once.norm();
  EXPECT_NEAR(growth / std::pow(rho, n), 1, 0.01)
      << name << ", zeta " << zeta << ", at " << share << " of the limit, " << n << " steps, rho " << rho;
}

TEST(StabilityVerification, IntegratorsGrowAsTheirSchemesSay) {
  for (const double zeta : {0.02, 0.1, 0.5, 2.0})
    for (const double share : {0.99, 1.01}) {
      for (const DampedBy by : {DampedBy::mass, DampedBy::stiffness, DampedBy::mode}) {
        expect_growth("explicit-euler", explicit_euler, zeta, by, false, share);
        expect_growth("symplectic-euler", symplectic_euler, zeta, by, true, share);
        expect_growth("central-difference", central_difference, zeta, by, false, share);
      }
      expect_growth("central-difference", central_difference, zeta, DampedBy::mass, true, share);
      expect_growth("central-difference, lagged damping", central_difference, zeta, DampedBy::stiffness, true, share);
      expect_growth("central-difference, lagged damping", central_difference, zeta, DampedBy::mode, true, share);
    }
  for (const double share : {0.99, 1.01})
    for (const bool is_lumped : {false, true}) {
      expect_growth("symplectic-euler", symplectic_euler, 0, DampedBy::mass, is_lumped, share);
      expect_growth("central-difference", central_difference, 0, DampedBy::mass, is_lumped, share);
    }
}

// At any step, growth as the matrix says: explicit Euler undamped, which is never stable, and average acceleration.
TEST(StabilityVerification, UndampedExplicitEulerGrowsAtEveryStep) {
  for (const double omega_h : {0.003, 0.03, 0.3}) {
    const double n = std::round(2 * std::log(100.) / std::log1p(omega_h * omega_h));
    const Matrix2d power = after(explicit_euler, two_masses(0, DampedBy::mass, false), omega_h / 3, n);
    EXPECT_NEAR(std::sqrt(power.determinant()) / std::pow(1 + omega_h * omega_h, n / 2), 1, 0.01);
  }
}

// The n-th power of the matrix, of which a double eigenvalue, at critical damping, has no growth of its own.
constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr double ratios[] = {0.02, 0.5, 1 - ulp / 2, 1.0, 1 + ulp, 1e8};
void expect_power(const std::string& name, Make make, double omega_h, double zeta, DampedBy by) {
  constexpr int n = 20;
  const Matrix2d A = scheme(name).amplification(omega_h, zeta);
  Matrix2d expected = Matrix2d::Identity();
  for (int i = 0; i < n; ++i) expected = A * expected;
  const Matrix2d power = after(make, two_masses(zeta, by, false), omega_h / 3, n);
  EXPECT_LT((power - expected).norm(), 1e-9 * expected.norm() + 1e-15)  // where a step leaves nothing of the start
      << name << ", zeta " << zeta << ", omega h " << omega_h;
}

TEST(StabilityVerification, NewmarkDecaysAsItsSchemeSays) {
  for (const double omega_h : {0.3, 2.0, 40.0, 1e4})
    for (const double zeta : ratios) expect_power("newmark", newmark, omega_h, zeta, DampedBy::stiffness);
}

TEST(StabilityVerification, EulersStepAsTheirSchemesSayAtExtremeDamping) {
  for (const double zeta : ratios)
    for (const double share : {0.5, 0.99, 1.01, 1.5})
      for (const DampedBy by : {DampedBy::mass, DampedBy::stiffness, DampedBy::mode}) {
        const auto of = [&](const char* name, Make make) {
          expect_power(name, make, share * stable_omega_h(scheme(name), zeta), zeta, by);
        };
        of("explicit-euler", explicit_euler);
        of("symplectic-euler", symplectic_euler);
      }
}

}  // namespace
}  // namespace mb
