#include "mechanics/algebra/dense_eigen.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

// LAPACK 3: several times as fast as Eigen's from some hundred rows on. Fortran passes the lengths of characters last.
extern "C" {
void dsyevd_(const char* vectors, const char* triangle, const int* n, double* A, const int* stride, double* values,
             double* work, const int* n_work, int* whole, const int* n_whole, int* info, size_t, size_t);
void dgeev_(const char* left, const char* right, const int* n, double* A, const int* stride, double* real,
            double* imaginary, double* U, const int* stride_U, double* V, const int* stride_V, double* work,
            const int* n_work, int* info, size_t, size_t);
void dgesdd_(const char* vectors, const int* m, const int* n, double* A, const int* stride, double* sigma, double* U,
             const int* stride_U, double* V_transposed, const int* stride_V, double* work, const int* n_work,
             int* whole, int* info, size_t);
}

namespace mb {
namespace {

int int_of(Index size) {
  if (size > std::numeric_limits<int>::max()) throw std::invalid_argument("dense matrices: too many rows or columns");
  return static_cast<int>(size);
}

int size_of(const MatrixXd& A) {
  if (A.rows() != A.cols()) throw std::invalid_argument("dense eigenvalues: the matrix is not square");
  return int_of(A.rows());
}

// Calls twice: work[0] says at first how much of it is wanted.
template <class Call>
int with_work(const Call& call) {
  std::vector<double> work(1);
  std::vector<int> whole(1);
  if (const int info = call(work, -1, whole, -1)) return info;
  if (!(work[0] >= 1 && work[0] <= std::numeric_limits<int>::max())) return -1;  // it counts in int, and wraps
  work.resize(static_cast<size_t>(work[0]));
  whole.resize(static_cast<size_t>(whole[0]));
  return call(work, static_cast<int>(work.size()), whole, static_cast<int>(whole.size()));
}

// Nothing where the solver does not converge. LAPACK may not end on what is not finite.
std::optional<EigenPairs> symmetric(MatrixXd A, bool with_vectors) {
  const int n = size_of(A);
  EigenPairs pairs{VectorXd(n), MatrixXd(n, 0)};
  if (n == 0) return pairs;
  if (!A.triangularView<Eigen::Lower>().toDenseMatrix().allFinite()) return std::nullopt;
  const int info = with_work([&](auto& work, int n_work, auto& whole, int n_whole) {
    int outcome = 0;
    dsyevd_(with_vectors ? "V" : "N", "L", &n, A.data(), &n, pairs.values.data(), work.data(), &n_work, whole.data(),
            &n_whole, &outcome, 1, 1);
    return outcome;
  });
  if (info != 0) return std::nullopt;
  if (with_vectors) pairs.vectors = std::move(A);
  return pairs;
}

EigenPairs converged(std::optional<EigenPairs> pairs) {
  if (!pairs) throw std::runtime_error("the dense symmetric eigensolver has not converged");
  return *std::move(pairs);
}

// K x = lambda M x as C y = lambda y with C = L^-1 K L^-T, y = L^T x, M = L L^T.
std::optional<EigenPairs> generalized(const MatrixXd& K, const MatrixXd& M, bool with_vectors) {
  const Eigen::LLT<MatrixXd> factor(M);
  if (factor.info() != Eigen::Success) return std::nullopt;
  MatrixXd C = K.selfadjointView<Eigen::Lower>();
  factor.matrixL().solveInPlace<Eigen::OnTheLeft>(C);
  factor.matrixU().solveInPlace<Eigen::OnTheRight>(C);
  auto pairs = symmetric(std::move(C), with_vectors);
  if (pairs && with_vectors) factor.matrixU().solveInPlace(pairs->vectors);
  return pairs;
}

// Divide and conquer. Of some graded A Eigen's BDCSVD (3.4.0) says success, and V is not orthonormal.
Svd decomposed(MatrixXd A, bool with_vectors) {
  const int m = int_of(A.rows()), n = int_of(A.cols()), k = std::min(m, n), stride = std::max(m, 1),
            rank = std::max(k, 1);
  Svd svd{MatrixXd(m, with_vectors ? k : 0), VectorXd(k), MatrixXd(n, 0)};
  MatrixXd V_transposed(with_vectors ? k : 0, n);
  std::vector<int> exchanges(8 * static_cast<size_t>(k));
  const auto call = [&](auto& work, int n_work, auto&, int) {
    int outcome = 0;
    dgesdd_(with_vectors ? "S" : "N", &m, &n, A.data(), &stride, svd.sigma.data(), svd.U.data(), &stride,
            V_transposed.data(), &rank, work.data(), &n_work, exchanges.data(), &outcome, 1);
    return outcome;
  };
  if (!A.allFinite() || (k > 0 && with_work(call) != 0))
    throw std::runtime_error("the singular values have not converged");
  svd.V = V_transposed.transpose();
  return svd;
}

}  // namespace

EigenPairs symmetric_eigen(const MatrixXd& A) { return converged(symmetric(A, true)); }
VectorXd symmetric_eigenvalues(const MatrixXd& A) { return converged(symmetric(A, false)).values; }

Eigen::VectorXcd general_eigenvalues(const MatrixXd& A) {
  const int n = size_of(A), none = 1;
  VectorXd real(n), imaginary(n);
  MatrixXd left = A;
  const auto call = [&](auto& work, int n_work, auto&, int) {
    int outcome = 0;
    dgeev_("N", "N", &n, left.data(), &n, real.data(), imaginary.data(), nullptr, &none, nullptr, &none, work.data(),
           &n_work, &outcome, 1, 1);
    return outcome;
  };
  if (!A.allFinite() || (n > 0 && with_work(call) != 0))
    throw std::runtime_error("the dense eigensolver has not converged");
  Eigen::VectorXcd values(n);
  values.real() = real;
  values.imag() = imaginary;
  return values;
}

std::optional<EigenPairs> generalized_eigen(const MatrixXd& K, const MatrixXd& M) { return generalized(K, M, true); }

std::optional<VectorXd> generalized_eigenvalues(const MatrixXd& K, const MatrixXd& M) {
  auto pairs = generalized(K, M, false);
  return pairs ? std::optional(std::move(pairs->values)) : std::nullopt;
}

Svd thin_svd(const MatrixXd& A) { return decomposed(A, true); }
VectorXd singular_values(const MatrixXd& A) { return decomposed(A, false).sigma; }

// A + i B has those of [A -B; B A], where each stands twice.
VectorXd singular_values(const Eigen::MatrixXcd& A) {
  MatrixXd real(2 * A.rows(), 2 * A.cols());
  real << A.real(), -A.imag(), A.imag(), A.real();
  return singular_values(real)(Eigen::seq(0, Eigen::last, 2));
}

double spectral_norm(const MatrixXd& A) {
  if (A.size() == 0) return 0;
  return std::sqrt(std::max(0.0, symmetric_eigenvalues(A.transpose() * A).maxCoeff()));
}

}  // namespace mb
