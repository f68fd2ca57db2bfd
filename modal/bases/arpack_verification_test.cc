// Lowest modes by a route of their own, ARPACK's Lanczos with one vector on Eigen's factor at another shift, rigid
// modes left in: beside block Lanczos, which is what the suite uses, and a dense solver.
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

#include <numeric>

#include "cases/scene/case_files.h"
#include "mechanics/algebra/noise.h"
#include "mechanics/verified_test.h"
#include "modal/bases/arpack.h"
#include "modal/bases/dense_modes.h"
#include "modal/bases/eigenmodes.h"
#include "modal/bases/mode_differences_test.h"
#include "reference/full_model.h"

namespace mb {
namespace {

constexpr int n_wanted = 30;  // rigid ones included

// Pairs of (K - sigma M)^-1 M as they are found, theta = 1 / (lambda - sigma).
class ByArpack {
 public:
  ByArpack(const System& system, double shift) : M_(system.M), shift_(shift), Phi_(system.M.rows(), 0) {
    factor_.compute(system.K - shift * system.M);
    if (factor_.info() != Eigen::Success) throw std::runtime_error("Eigen's factor failed");
    add(largest(n_wanted, 3 * n_wanted, 1));
    // One vector finds copies of a multiple eigenvalue by rounding alone. What was missed is looked for where all that
    // was found is taken out of the operator, until nothing is left above the last one wanted.
    for (unsigned seed = 2; seed < 40; ++seed) {
      const RitzPairs next = largest(1, 20, seed);
      VectorXd sorted = theta_;
      std::ranges::sort(sorted, std::ranges::greater());
      if (next.theta[0] < sorted[n_wanted - 1]) return;
      add(next);
    }
    throw std::runtime_error("ARPACK misses modes");
  }
  // All that were found, ascending, rigid ones first.
  ElasticModes modes() const {
    std::vector<Index> order(static_cast<size_t>(theta_.size()));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, std::ranges::greater(), [&](Index i) { return theta_[i]; });
    return {theta_(order).cwiseInverse().array() + shift_, Phi_(Eigen::all, order)};
  }

 private:
  RitzPairs largest(int n, int n_vectors, unsigned seed) const {
    const Operator apply = [&](const VectorXd&, const VectorXd& Mx) -> VectorXd {
      return factor_.solve(Mx) - Phi_ * theta_.cwiseProduct(Phi_.transpose() * Mx);
    };
    const InnerProduct mass = [&](const VectorXd& x) -> VectorXd { return M_ * x; };
    return largest_ritz(apply, mass, n, n_vectors, 0, uniform_noise(M_.rows(), seed));
  }
  void add(const RitzPairs& found) {
    const Index n = theta_.size();
    theta_.conservativeResize(n + found.theta.size());
    Phi_.conservativeResize(Eigen::NoChange, n + found.theta.size());
    theta_.tail(found.theta.size()) = found.theta;
    Phi_.rightCols(found.theta.size()) = found.vectors;
  }

  const SparseMatrix& M_;
  double shift_;
  Eigen::SimplicialLDLT<SparseMatrix> factor_;
  VectorXd theta_;
  MatrixXd Phi_;
};

ElasticModes elastic(const ElasticModes& all, Index n_rigid) {
  return {all.lambda.tail(all.lambda.size() - n_rigid), all.Phi.rightCols(all.lambda.size() - n_rigid)};
}

using testing::ModeDifferences;

// Of elastic modes alone.
ModeDifferences differences(const SparseMatrix& M, const ElasticModes& one, const ElasticModes& other) {
  const ModeDifferences found = testing::mode_differences(M, 0, one.lambda, one.Phi, other.lambda, other.Phi);
  EXPECT_GE(found.n, 21) << "all but six rigid ones and a cluster that was cut";
  return found;
}

struct Routes {
  ModeDifferences lanczos, dense;
};
Routes compared(const std::string& file, const Resolution* mesh, bool densely) {
  const Scene scene = read_toml(test::cases_folder() / file, test::vocabulary());
  const Body& body = scene.bodies[0];
  const auto model = full_model(scene, body, mesh ? *mesh : body.resolution);
  const System& system = model->system();
  const Index n_rigid = system.R.cols();
  const ElasticModes all = ByArpack(system, 2.7 * physical_shift(body)).modes();
  // Rigid modes were not told to it: it finds as many zeros, to rounding of the factor.
  EXPECT_LT(all.lambda.head(n_rigid).cwiseAbs().sum(), 1e-8 * all.lambda[n_rigid]);
  const ElasticModes own = elastic(all, n_rigid);
  Routes worst;
  const ShiftedFactor shifted = shifted_factor(system, physical_shift(body));
  EXPECT_GT(system.K.rows(), 500) << "smaller ones the suite leaves to a dense solver";
  worst.lanczos = differences(system.M, own, elastic_modes(system, n_wanted, shifted));
  if (densely) worst.dense = differences(system.M, own, dense_modes(system));
  return worst;
}

void expect_same(const std::string& what, const std::string& other, const ModeDifferences& worst) {
  testing::expect_verified(
      {.quantity = "frequencies of " + what + ", relative, the worst",
       .reference = "second route",
       .source = other + " beside ARPACK with one vector on Eigen's factor at another shift",
       .uncertainty = "1e-10, residuals of either, squared in the eigenvalue, and rounding of the factors",
       .tolerance = 1e-9,
       .why = "Rounding times the spread of the spectrum, 1e6 at most; a mode missed would be off by per cents."},
      worst.frequency);
  testing::expect_verified(
      {.quantity = "subspaces of " + what + ", clusters apart by 1e-3 and more, sine of the angle times the gap",
       .reference = "second route",
       .source = other + " beside ARPACK with one vector on Eigen's factor at another shift",
       .uncertainty = "1e-10, residuals of either",
       .tolerance = 1e-10,
       .why = "The residual at which block Lanczos stops, which turns a subspace by itself over the gap."},
      worst.subspace);
}

TEST(ArpackVerification, FindsTheModesOfACylinderCase) {
  const Routes worst = compared("cylinder-bending.toml", nullptr, false);
  expect_same("a free cylinder, its lowest 21 and more on the mesh of case cylinder-bending", "block Lanczos",
              worst.lanczos);
}

TEST(ArpackVerification, FindsTheModesOfACylinderOnAFewCellsAsADenseSolverDoes) {
  const Resolution few{3, {0, 4}};  // one of the rival meshes of the case, 624 degrees of freedom
  const Routes worst = compared("cylinder-bending.toml", &few, true);
  expect_same("a free cylinder, its lowest 21 and more on four cubic cells", "block Lanczos", worst.lanczos);
  expect_same("a free cylinder, its lowest 21 and more on four cubic cells", "a dense solver", worst.dense);
}

TEST(ArpackVerification, FindsNearlyDegeneratePairs) {
  const Routes worst = compared("hard/nearly-degenerate-bar.toml", nullptr, true);
  expect_same("a bar whose pairs differ by 1e-4, its lowest 21 and more on the mesh of case nearly-degenerate-bar",
              "block Lanczos", worst.lanczos);
  expect_same("a bar whose pairs differ by 1e-4, its lowest 21 and more on the mesh of case nearly-degenerate-bar",
              "a dense solver", worst.dense);
}

}  // namespace
}  // namespace mb
