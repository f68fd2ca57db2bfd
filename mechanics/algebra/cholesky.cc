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

// (smallest / largest diagonal entry of L)^2, a cheap upper bound of 1/cond(A): rounding leaves about 1e-16 times a few
// hundred in a pivot that vanishes, regular matrices of this suite stay above 1e-11.
constexpr double singular = 1e-13;

void factorise(cholmod_sparse A, cholmod_factor* L, cholmod_common* common) {
  cholmod_factorize(&A, L, common);
  if (common->status < 0) throw std::runtime_error(fmt::format("Cholesky: {}", cholmod::describe(common->status)));
  if (L->minor < L->n) {
    const int column = static_cast<const int*>(L->Perm)[L->minor];
    throw std::runtime_error(
        fmt::format("Cholesky: matrix of {} rows is not positive definite at column {}", L->n, column));
  }
  const double rcond = cholmod_rcond(L, common);
  if (!(rcond > singular))
    throw std::runtime_error(
        fmt::format("Cholesky: matrix of {} rows is singular to working precision (pivot ratio {:.1e})", L->n, rcond));
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
