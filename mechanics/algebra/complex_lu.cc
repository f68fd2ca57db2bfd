#include "mechanics/algebra/complex_lu.h"

#include <fmt/format.h>
#include <umfpack.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "mechanics/algebra/umfpack_status.h"

namespace mb {
namespace {

// Smallest over largest pivot. Below this a solution of working precision keeps fewer than two digits.
constexpr double singular = 1e-14;

void require_ok(int status) {
  if (status != UMFPACK_OK) throw std::runtime_error("ComplexLu: " + umfpack::describe(status));
}

void check(const SparseMatrixXcd& A) {
  if (A.rows() == 0 || A.rows() != A.cols())
    throw std::invalid_argument("ComplexLu: needs a square matrix of at least one row");
  if (!A.isCompressed()) throw std::invalid_argument("ComplexLu: needs a compressed matrix");
  const auto is_finite = [](Complex x) { return std::isfinite(x.real()) && std::isfinite(x.imag()); };
  if (!std::all_of(A.valuePtr(), A.valuePtr() + A.nonZeros(), is_finite))
    throw std::invalid_argument("ComplexLu: the matrix has an entry that is not finite");
}

bool same_pattern(const SparseMatrixXcd& A, const SparseMatrixXcd& B) {
  return A.rows() == B.rows() && A.cols() == B.cols() && A.nonZeros() == B.nonZeros() &&
         std::equal(A.outerIndexPtr(), A.outerIndexPtr() + A.outerSize() + 1, B.outerIndexPtr()) &&
         std::equal(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros(), B.innerIndexPtr());
}

// The packed form: real and imaginary parts alternate, as in std::complex; the second array is absent.
const double* packed(const Complex* x) { return reinterpret_cast<const double*>(x); }
double* packed(Complex* x) { return reinterpret_cast<double*>(x); }

}  // namespace

struct ComplexLu::Factor {
  SparseMatrixXcd A;  // for the iterative refinement of solves
  std::array<double, UMFPACK_CONTROL> control{};
  void* symbolic = nullptr;
  void* numeric = nullptr;

  explicit Factor(const SparseMatrixXcd& matrix) : A(matrix) {
    umfpack_zi_defaults(control.data());
    control[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;  // three-dimensional meshes: less fill than by minimum degree
    const int n = static_cast<int>(A.rows());
    require_ok(umfpack_zi_symbolic(n, n, A.outerIndexPtr(), A.innerIndexPtr(), packed(A.valuePtr()), nullptr, &symbolic,
                                   control.data(), nullptr));
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;
  ~Factor() {
    umfpack_zi_free_numeric(&numeric);
    umfpack_zi_free_symbolic(&symbolic);
  }

  void factorise() {
    umfpack_zi_free_numeric(&numeric);
    std::array<double, UMFPACK_INFO> info{};
    require_ok(umfpack_zi_numeric(A.outerIndexPtr(), A.innerIndexPtr(), packed(A.valuePtr()), nullptr, symbolic,
                                  &numeric, control.data(), info.data()));
    if (info[UMFPACK_RCOND] > singular) return;
    umfpack_zi_free_numeric(&numeric);
    throw std::runtime_error(fmt::format("ComplexLu: the matrix is singular to working precision (pivot ratio {:.1e})",
                                         info[UMFPACK_RCOND]));
  }
};

ComplexLu::ComplexLu(const SparseMatrixXcd& A) {
  check(A);
  factor_ = std::make_unique<Factor>(A);
  factor_->factorise();
}

ComplexLu::~ComplexLu() = default;
ComplexLu::ComplexLu(ComplexLu&&) noexcept = default;

void ComplexLu::refactor(const SparseMatrixXcd& A) {
  check(A);
  if (!same_pattern(A, factor_->A)) throw std::invalid_argument("ComplexLu::refactor: the pattern has changed");
  factor_->A = A;
  factor_->factorise();
}

VectorXcd ComplexLu::solve(const VectorXcd& b) const {
  const Factor& f = *factor_;
  if (b.size() != f.A.rows()) throw std::invalid_argument("ComplexLu::solve: right-hand side of another size");
  if (f.numeric == nullptr) throw std::runtime_error("ComplexLu::solve: the last factorisation has failed");
  VectorXcd x(b.size());
  require_ok(umfpack_zi_solve(UMFPACK_A, f.A.outerIndexPtr(), f.A.innerIndexPtr(), packed(f.A.valuePtr()), nullptr,
                              packed(x.data()), nullptr, packed(b.data()), nullptr, f.numeric, f.control.data(),
                              nullptr));
  return x;
}

}  // namespace mb
