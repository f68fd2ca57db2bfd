#include "modal/bases/arpack.h"

#include <gtest/gtest.h>

#include "mechanics/algebra/noise.h"

namespace mb {
namespace {

// T = B^-1 A is self-adjoint in B; both diagonal, eigenvalues 1 ... n.
struct Diagonal {
  VectorXd theta, b;
  explicit Diagonal(Index n)
      : theta(VectorXd::LinSpaced(n, 1, static_cast<double>(n))), b(uniform_noise(n, 9).array() + 2) {}
  Operator by_x() const {
    return [this](const VectorXd& x, const VectorXd&) -> VectorXd { return theta.cwiseProduct(x); };
  }
  Operator by_Bx() const {
    return [this](const VectorXd&, const VectorXd& Bx) -> VectorXd { return theta.cwiseProduct(Bx).cwiseQuotient(b); };
  }
  InnerProduct inner_product() const {
    return [this](const VectorXd& x) -> VectorXd { return b.cwiseProduct(x); };
  }
};

TEST(LargestRitz, FindsTheTopOfASpectrum) {
  const Diagonal problem(200);
  for (const Operator& apply : {problem.by_x(), problem.by_Bx()}) {
    const RitzPairs top = largest_ritz(apply, problem.inner_product(), 5, 20, 0, uniform_noise(200, 1));
    ASSERT_EQ(top.theta.size(), 5);
    for (Index i = 0; i < 5; ++i) {
      EXPECT_NEAR(top.theta(i), static_cast<double>(200 - i), 1e-11);
      const VectorXd x = top.vectors.col(i);
      EXPECT_NEAR(x.dot(problem.b.cwiseProduct(x)), 1, 1e-12);
      EXPECT_NEAR(std::abs(x(199 - i)), 1 / std::sqrt(problem.b(199 - i)), 1e-10);
    }
    EXPECT_GT(top.n_applications, 20);
  }
}

TEST(LargestRitz, RepeatsItself) {
  const Diagonal problem(100);
  const auto run = [&] {
    return largest_ritz(problem.by_x(), problem.inner_product(), 3, 12, 1e-10, uniform_noise(100, 1)).vectors;
  };
  EXPECT_EQ(run(), run());
}

TEST(LargestRitz, SaysWhyItFails) {
  const Diagonal problem(100);
  const VectorXd start = uniform_noise(100, 1);
  const auto run = [&](int wanted, int vectors, const VectorXd& from) {
    return largest_ritz(problem.by_x(), problem.inner_product(), wanted, vectors, 1e-10, from);
  };
  EXPECT_THROW(run(0, 10, start), std::invalid_argument);
  EXPECT_THROW(run(10, 10, start), std::invalid_argument);
  EXPECT_THROW(run(10, 101, start), std::invalid_argument);
  EXPECT_THROW(run(5, 20, VectorXd::Zero(100)), std::invalid_argument);
  EXPECT_THROW(run(5, 20, NAN * start), std::invalid_argument);
  // A spectrum crowded beyond all resolution at its top, two vectors to find it with: no convergence in 300 restarts.
  const Operator crowded = [](const VectorXd& x, const VectorXd&) -> VectorXd {
    return x.array() * (1 - Eigen::ArrayXd::LinSpaced(x.size(), 0, 1).square() * 1e-6);
  };
  const InnerProduct identity = [](const VectorXd& x) { return x; };
  EXPECT_THROW(largest_ritz(crowded, identity, 1, 2, 0, uniform_noise(3000, 1)), std::runtime_error);
}

}  // namespace
}  // namespace mb
