#include "modal/bases/eigenmodes.h"
#include "mechanics/algebra/dense_eigen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numeric>
#include <random>
#include <sstream>

#include "mechanics/algebra/box_test_system.h"
#include "mechanics/algebra/noise.h"
#include "mechanics/verified_test.h"
#include "modal/bases/shift_invert.h"

namespace mb {
namespace {

using testing::box_system;
using testing::expect_verified;
using testing::slip_faces;

// Rows of comma-separated cells behind the comments and the header line.
std::vector<std::vector<std::string>> table(const std::string& name) {
  std::ifstream file(MB_SOURCE_DIR "/cases/exact/tables/" + name);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    rows.push_back(cells);
  }
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

System slip_cube() { return box_system({.cells = {4, 4, 4}, .fixed = slip_faces({1, 1, 1})}).system; }
System free_beam(int n = 5) {
  return box_system({.cells = {n - 1, n, 3 * n}, .size = {0.09, 0.1, 0.3}, .E = 2e4, .nu = 0.45, .rho = 1100}).system;
}
// -0.01 E/(rho l^2) of the body above.
constexpr double beam_shift = -0.01 * 2e4 / (1100 * 0.3 * 0.3);

double largest_relative_difference(const VectorXd& a, const VectorXd& b) {
  return ((a - b).array() / b.array()).abs().maxCoeff();
}

VectorXd slip_cube_table() {
  std::vector<double> omega;
  for (const auto& row : table("slipbox_discrete_Q1_cube4.csv")) omega.push_back(std::stod(row[4]));
  std::ranges::sort(omega);
  return Eigen::Map<VectorXd>(omega.data(), static_cast<Index>(omega.size()));
}

// The exact spectrum of the mesh, computed from its symbol: 1e-10 as the tables' readme demands.
TEST(SlipCubeVerification, WholeSpectrumByTheDenseSolver) {
  const VectorXd expected = slip_cube_table();
  ASSERT_EQ(expected.size(), 225);
  const Modes modes = lowest_modes(slip_cube(), 225, -0.01);
  ASSERT_EQ(modes.size(), 225);
  EXPECT_EQ(modes.n_rigid, 0);
  EXPECT_LT(largest_relative_difference(modes.omega, expected), 1e-10);
  EXPECT_NEAR(modes.lambda_max, std::pow(expected(224), 2), 1e-10 * modes.lambda_max);
}

TEST(SlipCubeVerification, LowestModesByLanczosWithAllTheirCopies) {
  const Modes modes = lowest_modes(slip_cube(), 40, -0.01);
  ASSERT_GE(modes.size(), 40);
  ASSERT_LT(modes.size(), 60) << "not by Lanczos";
  ASSERT_TRUE(modes.omega.allFinite());
  expect_verified(
      {.quantity = "the 40 lowest frequencies of a box on sliding supports and those of the same multiplet, by "
                   "Lanczos, 4 x 4 x 4 trilinear cells, relative, the worst",
       .reference = "exact solution",
       .source = "of the discrete problem, by its symbol: slipbox_discrete_Q1_cube4.csv",
       .uncertainty = "5e-14, rounding",
       .tolerance = 1e-10,
       .why = "Residuals of 1e-8 at most come into eigenvalues squared; a copy missed among multiple ones would "
              "be off by per cents."},
      largest_relative_difference(modes.omega, slip_cube_table().head(modes.size())));
}

class FreeCubeVerification : public ::testing::TestWithParam<int> {};

// Same mesh, same matrices: 1e-8, with ten printed digits.
TEST_P(FreeCubeVerification, SameMeshSameFrequencies) {
  const auto row = table("free_fem_discrete.csv").at(static_cast<size_t>(GetParam()));
  ASSERT_EQ(row[0], "cube");
  const double nu = 0.3, E = 7e10, rho = 2700, L = 0.2;
  const int n = std::stoi(row[2]);
  const System cube = box_system({{n, n, n}, std::stoi(row[1]), {L, L, L}, E, nu, rho}).system;
  ASSERT_EQ(cube.K.rows(), std::stoi(row[5]));
  const Modes modes = lowest_modes(cube, 20, -0.01 * E / (rho * L * L));
  ASSERT_GE(modes.size(), 26);
  EXPECT_EQ(modes.n_rigid, 6);
  EXPECT_EQ(modes.omega.head(6).norm(), 0);
  VectorXd expected(20);
  for (Index i = 0; i < 20; ++i) expected(i) = std::stod(row[7 + static_cast<size_t>(i)]);
  const double c_t = std::sqrt(E / (2 * (1 + nu)) / rho);
  EXPECT_LT(largest_relative_difference(modes.omega.segment(6, 20) * L / c_t, expected), 1e-8);
}
INSTANTIATE_TEST_SUITE_P(Meshes, FreeCubeVerification, ::testing::Values(0, 1, 2, 3, 4, 5, 6));

TEST(LowestModes, AreMOrthonormalAndSolveTheEigenproblem) {
  const System beam = free_beam();
  const Modes modes = lowest_modes(beam, 30, beam_shift);
  ASSERT_GE(modes.size(), 36);
  const MatrixXd gram = modes.Phi.transpose() * (beam.M * modes.Phi);
  EXPECT_LT((gram - MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(modes.Phi.leftCols(6), beam.R);
  EXPECT_LT(modes.residual.maxCoeff(), 1e-8);
  for (Index i = 6; i < modes.size(); ++i) {
    const VectorXd phi = modes.Phi.col(i);
    EXPECT_NEAR(phi.dot(beam.K * phi), std::pow(modes.omega(i), 2), 1e-10 * std::pow(modes.omega(i), 2));
  }
}

TEST(LowestModes, LanczosAndDenseSolverAgree) {
  const System beam = free_beam(3);
  const Modes few = lowest_modes(beam, 10, beam_shift), all = lowest_modes(beam, 10000, beam_shift);
  ASSERT_EQ(all.size(), beam.K.rows());
  EXPECT_LT(largest_relative_difference(few.omega.tail(few.size() - 6), all.omega.segment(6, few.size() - 6)), 1e-10);
  EXPECT_GE(few.lambda_max, all.lambda_max * (1 - 1e-12));
  EXPECT_LE(few.lambda_max, all.lambda_max * 1.03);
  // Same subspace: the singular values of Phi^T M Psi are all 1.
  const MatrixXd overlap = few.Phi.transpose() * (beam.M * all.Phi.leftCols(few.size()));
  EXPECT_GT(singular_values(overlap).minCoeff(), 1 - 1e-10);
}

TEST(LowestModes, DoNotDependOnTheShift) {
  const System beam = free_beam();
  const Modes modes = lowest_modes(beam, 16, beam_shift);
  for (const double factor : {1e-2, 1e2, 1e4}) {
    const Modes other = lowest_modes(beam, 16, factor * beam_shift);
    ASSERT_EQ(other.size(), modes.size());
    EXPECT_LT(largest_relative_difference(other.omega.tail(16), modes.omega.tail(16)), 1e-10) << factor;
  }
}

TEST(LowestModes, DoNotDependOnTheNumbering) {
  const System beam = free_beam();
  std::vector<int> order(static_cast<size_t>(beam.K.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  const Eigen::PermutationMatrix<Eigen::Dynamic> P(Eigen::Map<Eigen::VectorXi>(order.data(), beam.K.rows()));
  System shuffled = beam;
  shuffled.K = P * beam.K * P.transpose();
  shuffled.M = P * beam.M * P.transpose();
  shuffled.R = P * beam.R;
  const Modes modes = lowest_modes(beam, 12, beam_shift), other = lowest_modes(shuffled, 12, beam_shift);
  ASSERT_EQ(other.size(), modes.size());
  EXPECT_LT(largest_relative_difference(other.omega.tail(12), modes.omega.tail(12)), 1e-10);
}

TEST(LowestModes, ScaleWithStiffnessAndMass) {
  System beam = free_beam(3);
  const Modes modes = lowest_modes(beam, 12, beam_shift);
  beam.K *= 1e7;
  beam.M *= 4;
  beam.R /= 2;
  const Modes other = lowest_modes(beam, 12, 1e7 / 4 * beam_shift);
  EXPECT_LT(largest_relative_difference(other.omega.tail(12), std::sqrt(1e7 / 4) * modes.omega.tail(12)), 1e-10);
}

TEST(LowestModes, AreTheSameInEveryRun) {
  const System beam = free_beam(3);
  const Modes modes = lowest_modes(beam, 8, beam_shift);
  lowest_modes(free_beam(4), 3, beam_shift);  // another problem between
  const Modes again = lowest_modes(beam, 8, beam_shift);
  EXPECT_EQ(modes.Phi, again.Phi);
  EXPECT_EQ(modes.omega, again.omega);
}

TEST(LowestModes, KeepMultipletsWhole) {
  const System cube = box_system({.cells = {5, 5, 5}}).system;  // elastic: 2, 3, 3, 3 ...
  for (const auto& [asked, kept] : {std::pair{1, 2}, {2, 2}, {3, 5}, {4, 5}, {5, 5}, {6, 8}})
    EXPECT_EQ(lowest_modes(cube, asked, -0.01).size(), 6 + kept) << asked;
}

// However many are asked for: those and what belongs to the last of them, no more.
TEST(LowestModes, EndWhereAMultipletDoes) {
  const System cube = box_system({.cells = {4, 4, 4}}).system;
  const VectorXd lambda = lowest_modes(cube, 60, -0.01).omega.array().square();
  for (int asked = 1; asked <= 48; ++asked) {
    Index end = 6 + asked;
    while (lambda[end] < (1 + 1e-6) * lambda[end - 1]) ++end;
    EXPECT_EQ(lowest_modes(cube, asked, -0.01).size(), end) << asked;
  }
}

// A pair of a slender bar: rounding of a spectrum eleven decades wide splits it by more than any fixed gap.
TEST(LowestModes, KeepWholeWhatRoundingSplits) {
  const VectorXd lambda{{100, 100.003, 400}};
  EXPECT_EQ(whole_multiplets(lambda, 1, 3), 1) << "3e-5 apart, and all that is known to be";
  EXPECT_EQ(whole_multiplets(lambda, 1, 3, 1e13), 1) << "eps lambda_max = 2e-3";
  EXPECT_EQ(whole_multiplets(lambda, 1, 3, 1e14), 2) << "eps lambda_max = 2e-2";
  EXPECT_EQ(whole_multiplets(lambda, 2, 3, 1e14), 2);
  EXPECT_EQ(whole_multiplets(lambda.head(2), 1, 3, 1e14), std::nullopt) << "a third may follow";
}

TEST(LowestModes, OfNoElasticModeAreTheRigidOnes) {
  const Modes modes = lowest_modes(free_beam(), 0, beam_shift);
  EXPECT_EQ(modes.size(), 6);
  EXPECT_EQ(modes.n_rigid, 6);
  EXPECT_LT(modes.residual.maxCoeff(), 1e-9);
  EXPECT_EQ(lowest_modes(slip_cube(), 0, -0.01).size(), 0);
}

TEST(LowestModes, OfASlidingBodyHaveThreeRigidModes) {
  const auto sliding = [](const Vector3d& x, int a) { return a == 2 && x[2] == 0; };
  const System body = box_system({.cells = {4, 5, 6}, .size = {1, 1.2, 1.5}, .fixed = sliding}).system;
  const Modes modes = lowest_modes(body, 10, -0.01);
  EXPECT_EQ(modes.n_rigid, 3);
  EXPECT_EQ((modes.omega.array() == 0).count(), 3);
}

TEST(LowestModes, RefuseBadInput) {
  const System beam = free_beam(3);
  EXPECT_THROW(lowest_modes(beam, -1, beam_shift), std::invalid_argument);
  EXPECT_THROW(lowest_modes(beam, 5, 0), std::invalid_argument);
  EXPECT_THROW(lowest_modes(beam, 5, NAN), std::invalid_argument);
  System wrong = beam;
  wrong.R.resize(3, 6);
  EXPECT_THROW(lowest_modes(wrong, 5, beam_shift), std::invalid_argument);
  wrong = beam;
  wrong.K = -beam.K;
  EXPECT_THROW(lowest_modes(wrong, 5, beam_shift), std::runtime_error);
  wrong = beam;
  wrong.M.coeffRef(7, 7) = -1;
  EXPECT_THROW(lowest_modes(wrong, 5, beam_shift), std::runtime_error);
  wrong = beam;
  wrong.K.coeffRef(0, 0) = NAN;
  EXPECT_THROW(lowest_modes(wrong, 5, beam_shift), std::invalid_argument);
}

TEST(LowestModes, RefuseRigidModesThatAreNot) {
  const System beam = free_beam(3);
  System wrong = beam;
  wrong.R.conservativeResize(beam.R.rows(), 5);  // one forgotten: lambda_1 = 0 appears among the elastic ones
  EXPECT_THROW(lowest_modes(wrong, 5, beam_shift), std::runtime_error);
  wrong = beam;
  wrong.R.col(2) += 1e-4 * beam.R.norm() * uniform_noise(beam.R.rows(), 1);
  EXPECT_THROW(lowest_modes(wrong, 5, beam_shift), GateFailure);
  const Eigen::LLT<MatrixXd> gram(wrong.R.transpose() * (wrong.M * wrong.R));  // orthonormal, yet not rigid
  wrong.R = gram.matrixU().solve<Eigen::OnTheRight>(wrong.R).eval();
  EXPECT_THROW(lowest_modes(wrong, 5, beam_shift), GateFailure);
}

TEST(Eigenmodes, HaveTheSameSignByWhicheverSolver) {
  const System beam = free_beam(4);
  const int n = 8;
  const Modes lanczos = lowest_modes(beam, n, beam_shift), dense = lowest_modes(beam, 300, beam_shift);
  ASSERT_LT(lanczos.size(), 100) << "not by Lanczos";
  ASSERT_GE(dense.size(), 306);
  for (Index i = 6; i < 6 + n; ++i)
    EXPECT_LT((lanczos.Phi.col(i) - dense.Phi.col(i)).norm(), 1e-5 * dense.Phi.col(i).norm()) << i;
}

}  // namespace
}  // namespace mb
