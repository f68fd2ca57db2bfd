#include "mechanics/geometry/polynomial_regression.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "mechanics/algebra/dense_eigen.h"

namespace mb {

namespace {

double ratio(double a, double b) { return b > 0 ? a / b : 0; }  // of residuals: both vanish where b does

// The first of the largest: what symmetry makes equal differs by rounding, which must not decide.
Index first_largest(const VectorXd& v) {
  Index best = 0;
  for (Index i = 1; i < v.size(); ++i)
    if (v[i] > (1 + 1e-6) * v[best]) best = i;
  return best;
}

// v less its part along the orthonormal columns of Q. Plain types throughout: every other one costs a compilation of
// the matrix product.
MatrixXd without(const Eigen::Ref<const MatrixXd>& Q, const MatrixXd& v) {
  const MatrixXd along = Q.transpose() * v;
  return v - Q * along;
}

struct Orthonormal {
  MatrixXd Q;                         // p x rank, Q^T Q = I
  std::vector<Index> kept;            // rank: the columns of B that Q spans, in its order
  std::vector<Index> rank_of_degree;  // degree + 1: how many columns of Q span the polynomials of degree 0, 1, ...
};

Orthonormal orthonormalise(const MatrixXd& B, int degree, double tolerance) {
  MatrixXd Q(B.rows(), std::min(B.rows(), B.cols()));
  Orthonormal result;
  Index rank = 0;
  for (int d = 0; d <= degree; ++d) {
    const Index first = n_monomials(d - 1), n = n_monomials(d) - first;
    MatrixXd rest = B.middleCols(first, n);
    for (int pass = 0; pass < 2; ++pass) rest = without(Q.leftCols(rank), rest);
    for (Index step = 0; step < n && rank < Q.cols(); ++step) {
      const VectorXd remainder = rest.colwise().norm();
      const Index pivot = first_largest(remainder);
      if (!(remainder[pivot] > tolerance)) break;
      const MatrixXd q = rest.col(pivot) / remainder[pivot];
      Q.col(rank) = without(Q.leftCols(rank), q);
      Q.col(rank) /= Q.col(rank).norm();
      result.kept.push_back(first + pivot);
      rest = without(Q.middleCols(rank++, 1), rest);
      rest.col(pivot).setZero();
    }
    result.rank_of_degree.push_back(rank);
  }
  result.Q = Q.leftCols(rank);
  return result;
}

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::invalid_argument("regression onto polynomials: " + otherwise);
}

void require_valid(const Monomials& monomials, const Matrix3Xd& X, const VectorXd& w, const MatrixXd& U,
                   const RegressionTolerances& tolerances) {
  require(X.cols() > 0, "no points");
  require(w.size() == X.cols(), fmt::format("{} weights for {} points", w.size(), X.cols()));
  require(U.rows() == 3 * X.cols(), fmt::format("modes of {} rows for {} points", U.rows(), X.cols()));
  for (Index i = 0; i < X.cols(); ++i) {
    require(X.col(i).allFinite(), fmt::format("point {} is not finite", i));
    require(monomials.scaled(Vector3d(X.col(i))).cwiseAbs().maxCoeff() <= PolynomialMap::reach,
            fmt::format("point {} is far outside the box of the monomials", i));
    require(w[i] >= 0 && std::isfinite(w[i]), fmt::format("weight {} of point {} is not >= 0 and finite", w[i], i));
  }
  require(w.maxCoeff() > 0, "all weights vanish");
  for (Index j = 0; j < U.cols(); ++j)
    for (Index i = 0; i < X.cols(); ++i)
      require(U.block<3, 1>(3 * i, j).allFinite(), fmt::format("mode {} is not finite at point {}", j, i));
  require(tolerances.rank >= 0 && tolerances.rank < 1,
          fmt::format("rank tolerance {} is not in [0, 1)", tolerances.rank));
  require(tolerances.drop >= 0, fmt::format("drop tolerance {} is not >= 0", tolerances.drop));
}

// x, y, z of the modes in columns 3j, 3j + 1, 3j + 2, each mode over its peak: p x 3r.
MatrixXd components(const MatrixXd& U, const VectorXd& peak) {
  const Index p = U.rows() / 3;
  MatrixXd result(p, 3 * U.cols());
  for (Index j = 0; j < U.cols(); ++j)
    result.middleCols(3 * j, 3) = Eigen::Map<const Matrix3Xd>(U.col(j).data(), 3, p).transpose() / peak[j];
  return result;
}

// The norm of every mode's three columns.
VectorXd norms(const MatrixXd& columns) {
  VectorXd result(columns.cols() / 3);
  for (Index j = 0; j < result.size(); ++j) result[j] = columns.middleCols(3 * j, 3).norm();
  return result;
}

// |phi - projection of phi on degree 0, 1, ...| / |phi|: r x degree + 1. Subtracted, not by Pythagoras: that would
// leave the root of rounding.
MatrixXd residuals_by_degree(const Orthonormal& basis, MatrixXd phi) {
  const VectorXd whole = norms(phi);
  MatrixXd result(whole.size(), static_cast<Index>(basis.rank_of_degree.size()));
  Index first = 0;
  for (Index d = 0; d < result.cols(); ++d) {
    const Index n = basis.rank_of_degree[static_cast<size_t>(d)] - first;
    phi = without(basis.Q.middleCols(first, n), phi);
    result.col(d) = norms(phi).binaryExpr(whole, [](double a, double b) { return ratio(a, b); });
    first += n;
  }
  return result;
}

// a with its smallest entries set to 0, as long as their magnitudes sum up to no more than allowed.
VectorXd without_small(VectorXd a, double allowed) {
  std::vector<Index> order(static_cast<size_t>(a.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return std::abs(a[i]) < std::abs(a[j]); });
  double sum = 0;
  for (const Index i : order) {
    sum += std::abs(a[i]);
    if (!(sum <= allowed)) break;
    a[i] = 0;
  }
  return a;
}

int highest_degree(const VectorXd& a) {
  int highest = 0;
  for (Index i = 0; i < a.size(); ++i)
    if (a[i] != 0) {
      const auto [x, y, z] = Monomials::exponents(i / 3);
      highest = std::max(highest, x + y + z);
    }
  return highest;
}

ModeFit assess(const VectorXd& a, const VectorXd& phi, const VectorXd& fit, const VectorXd& root_w, double peak) {
  const VectorXd scaled = phi / peak, left = (phi - fit) / peak;  // first: squares of small modes underflow
  const VectorXd whole = Eigen::Map<const Matrix3Xd>(scaled.data(), 3, root_w.size()).colwise().norm();
  const VectorXd rest = Eigen::Map<const Matrix3Xd>(left.data(), 3, root_w.size()).colwise().norm();
  return {ratio(rest.cwiseProduct(root_w).norm(), whole.cwiseProduct(root_w).norm()),
          ratio(rest.maxCoeff(), whole.maxCoeff()),
          highest_degree(a),
          (a.array() != 0).count(),
          {}};
}

}  // namespace

Regression regress(const Monomials& monomials, const Matrix3Xd& X, const VectorXd& w, const MatrixXd& U,
                   const RegressionTolerances& tolerances) {
  require_valid(monomials, X, w, U, tolerances);
  const Index r = U.cols();
  const VectorXd scaled_w = w / w.maxCoeff(), root_w = (scaled_w / scaled_w.sum()).cwiseSqrt();
  const VectorXd peak = U.cwiseAbs().colwise().maxCoeff().transpose().unaryExpr([](double u) { return u > 0 ? u : 1; });
  const MatrixXd B = root_w.asDiagonal() * monomials.values(X), phi = root_w.asDiagonal() * components(U, peak);

  const Orthonormal basis = orthonormalise(B, monomials.degree(), tolerances.rank);
  const Index rank = basis.Q.cols();
  const MatrixXd kept = B(Eigen::all, basis.kept), Qt = basis.Q.transpose(), R = Qt * kept;
  MatrixXd right(rank, 3 * r + rank);
  right << Qt * phi, MatrixXd::Identity(rank, rank);
  const MatrixXd left = R.triangularView<Eigen::Upper>().solve(right), inverse = left.rightCols(rank);
  const double condition = spectral_norm(kept) * spectral_norm(inverse);

  MatrixXd a = MatrixXd::Zero(3 * monomials.size(), r);
  for (Index k = 0; k < rank; ++k)
    for (Index j = 0; j < r; ++j)
      a.block<3, 1>(3 * basis.kept[static_cast<size_t>(k)], j) = left.block<1, 3>(k, 3 * j).transpose();
  const VectorXd rms = norms(phi);
  for (Index j = 0; j < r; ++j) a.col(j) = without_small(a.col(j), tolerances.drop * rms[j]);
  a *= peak.asDiagonal();

  const MatrixXd fit = PolynomialBasis(monomials, a).at(X), by_degree = residuals_by_degree(basis, phi);
  std::vector<ModeFit> modes;
  int degree = 0;
  for (Index j = 0; j < r; ++j) {
    modes.push_back(assess(a.col(j), U.col(j), fit.col(j), root_w, peak[j]));
    modes.back().residual_by_degree = by_degree.row(j);
    degree = std::max(degree, modes.back().degree);
  }
  const Monomials used(degree, monomials.centre(), monomials.half_extents());
  return {{used, a.topRows(3 * used.size())}, monomials.size(), rank, condition, modes};
}

}  // namespace mb
