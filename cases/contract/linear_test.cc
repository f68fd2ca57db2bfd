#include "cases/contract/linear.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

// A matrix of three full columns in each row, of 40 unknowns.
SparseMatrix of_mesh(Index n_values) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < n_values; ++i)
    for (Index k = 0; k < 3; ++k)
      entries.emplace_back(i, (7 * i + 5 * k) % 40, 1.0 / static_cast<double>(1 + i + 3 * k));
  SparseMatrix U(n_values, 40);
  U.setFromTriplets(entries.begin(), entries.end());
  return U;
}

TEST(Observe, MeshesAtAnyNumberOfTimesAreTheProduct) {
  const SparseMatrix U = of_mesh(90);
  for (const Index n_times : {0, 1, 15, 16, 17, 40}) {
    const MatrixXd q = MatrixXd::Random(40, n_times), seen = observe({U, {}}, q, {});
    ASSERT_EQ(seen.rows(), 90);
    ASSERT_EQ(seen.cols(), n_times);
    for (Index k = 0; k < n_times; ++k)
      EXPECT_LT((seen.col(k) - U * q.col(k)).norm(), 1e-15 * q.col(k).norm()) << k << " of " << n_times;
  }
}

TEST(Observe, LoadsAddTheirStaticPart) {
  const SparseMatrix U = of_mesh(30);
  const MatrixXd q = MatrixXd::Random(40, 20), of_load = MatrixXd::Random(30, 2), s = MatrixXd::Random(2, 20);
  const MatrixXd expected = MatrixXd(U) * q + of_load * s;
  EXPECT_LT((observe({U, of_load}, q, s) - expected).norm(), 1e-14 * expected.norm());
  EXPECT_LT((observe({MatrixXd(U), of_load}, q, s) - expected).norm(), 1e-14 * expected.norm());
}

}  // namespace
}  // namespace mb
