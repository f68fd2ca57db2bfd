#include "mechanics/algebra/cholesky.h"

#include <fmt/format.h>

#include <mutex>
#include <stdexcept>

#include "mechanics/algebra/cholmod_view.h"

namespace mb {

struct Cholesky::State {
  cholmod::Common common;
  cholmod_factor* L = nullptr;
  cholmod_dense *Y = nullptr, *E = nullptr;  // CHOLMOD's workspace of solves, kept between calls
  std::mutex solving;                        // for the workspace

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    cholmod_free_dense(&Y, &common);
    cholmod_free_dense(&E, &common);
    cholmod_free_factor(&L, &common);
  }
};

namespace {

// Rounding leaves some 1e-16 times a few hundred of a diagonal entry in the pivot that ought to vanish, whatever the
// units of that row (van der Sluis 1969); regular matrices of this suite stay above 1e-11.
constexpr double singular = 1e-13;

VectorXd diagonal(const cholmod_sparse& A) {
  const auto *begin = static_cast<const int*>(A.p), *row = static_cast<const int*>(A.i);
  const auto* value = static_cast<const double*>(A.x);
  VectorXd d = VectorXd::Zero(static_cast<Index>(A.ncol));
  for (Index j = 0; j < d.size(); ++j)
    for (int k = begin[j]; k < begin[j + 1]; ++k)
      if (row[k] == j) d(j) += value[k];
  return d;
}

// The least L_kk^2 over the diagonal entry of A that it came from. L is supernodal: dense blocks of columns.
double least_pivot_ratio(const cholmod_sparse& A, const cholmod_factor& L) {
  const VectorXd a = diagonal(A);
  const auto *first = static_cast<const int*>(L.super), *rows = static_cast<const int*>(L.pi);
  const auto *at = static_cast<const int*>(L.px), *of = static_cast<const int*>(L.Perm);
  const auto* value = static_cast<const double*>(L.x);
  double least = 1;
  for (size_t s = 0; s < L.nsuper; ++s)
    for (int j = 0; j < first[s + 1] - first[s]; ++j) {
      const double pivot = value[at[s] + static_cast<Index>(j) * (rows[s + 1] - rows[s] + 1)];
      const double ratio = pivot * pivot / a(of[first[s] + j]);
      if (!(ratio >= least)) least = ratio;
    }
  return least;
}

void factorise(cholmod_sparse A, cholmod_factor* L, cholmod_common* common) {
  cholmod_factorize(&A, L, common);
  if (common->status < 0) throw std::runtime_error(fmt::format("Cholesky: {}", cholmod::describe(common->status)));
  if (L->minor < L->n) {
    const int column = static_cast<const int*>(L->Perm)[L->minor];
    throw std::runtime_error(
        fmt::format("Cholesky: matrix of {} rows is not positive definite at column {}", L->n, column));
  }
  const double ratio = least_pivot_ratio(A, *L);
  if (!(ratio > singular))
    throw std::runtime_error(
        fmt::format("Cholesky: matrix of {} rows is singular to working precision (pivot ratio {:.1e})", L->n, ratio));
}

}  // namespace

Cholesky::Cholesky(const SparseMatrix& A) : state_(std::make_unique<State>()) {
  cholmod_sparse view = cholmod::lower_triangle(A);
  State& s = *state_;
  s.common->supernodal = CHOLMOD_SUPERNODAL;
  s.L = cholmod_analyze(&view, &s.common);
  if (s.L == nullptr) throw std::runtime_error(fmt::format("Cholesky: {}", cholmod::describe(s.common->status)));
  factorise(view, s.L, &s.common);
}

Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

void Cholesky::refactor(const SparseMatrix& A) {
  if (A.rows() != size()) throw std::invalid_argument("Cholesky::refactor: the size of the matrix has changed");
  factorise(cholmod::lower_triangle(A), state_->L, &state_->common);
}

VectorXd Cholesky::solve(const VectorXd& b) const {
  if (b.size() != size()) throw std::invalid_argument("Cholesky::solve: right-hand side of another size");
  VectorXd x(b.size());
  solve(b.data(), x.data());
  return x;
}

MatrixXd Cholesky::solve(const MatrixXd& b) const {
  if (b.rows() != size()) throw std::invalid_argument("Cholesky::solve: right-hand side of another size");
  // Blocks bound the workspace, which CHOLMOD keeps at its largest size.
  constexpr Index block = 32;
  MatrixXd x(b.rows(), b.cols());
  State& s = *state_;
  const std::lock_guard lock(s.solving);
  for (Index first = 0; first < b.cols(); first += block) {
    const Index n_columns = std::min(block, b.cols() - first);
    cholmod_dense B = cholmod::columns(b.col(first).data(), b.rows(), n_columns);
    cholmod_dense X = cholmod::columns(x.col(first).data(), b.rows(), n_columns);
    cholmod_dense* target = &X;
    if (!cholmod_solve2(CHOLMOD_A, s.L, &B, nullptr, &target, nullptr, &s.Y, &s.E, &s.common))
      throw std::runtime_error(fmt::format("Cholesky::solve: {}", cholmod::describe(s.common->status)));
  }
  return x;
}

void Cholesky::solve(const double* b, double* x) const {
  State& s = *state_;
  const std::lock_guard lock(s.solving);
  // CHOLMOD permutes b into Y, solves there and permutes back into an X that is large enough already: x itself.
  cholmod_dense B = cholmod::columns(b, size(), 1);
  cholmod_dense X = cholmod::columns(x, size(), 1);
  cholmod_dense* target = &X;
  if (!cholmod_solve2(CHOLMOD_A, s.L, &B, nullptr, &target, nullptr, &s.Y, &s.E, &s.common))
    throw std::runtime_error(fmt::format("Cholesky::solve: {}", cholmod::describe(s.common->status)));
}

Index Cholesky::size() const { return static_cast<Index>(state_->L->n); }

double Cholesky::nonzeros() const { return static_cast<double>(state_->L->xsize); }

}  // namespace mb
