#include "mechanics/algebra/inertia.h"

#include <umfpack.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/algebra/factorisable.h"
#include "mechanics/algebra/noise.h"
#include "mechanics/algebra/umfpack_status.h"

namespace mb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require_ok(int status) {  // warnings are told by what they leave: a vanished pivot
  if (status < 0) throw std::runtime_error("inertia: " + umfpack::describe(status));
}

std::array<double, UMFPACK_CONTROL> settings() {
  std::array<double, UMFPACK_CONTROL> control{};
  umfpack_di_defaults(control.data());
  control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
  control[UMFPACK_SYM_PIVOT_TOLERANCE] = control[UMFPACK_PIVOT_TOLERANCE] = 0;  // whatever its size: the diagonal one
  control[UMFPACK_FIXQ] = 1;                                                    // the columns' order stays the rows'
  control[UMFPACK_SINGLETONS] = 0;                                              // these, too
  control[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
  control[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;  // of meshes: less fill than by minimum degree
  control[UMFPACK_IRSTEP] = 0;                         // the residual is that of the factor alone
  return control;
}

class Factor {
 public:
  explicit Factor(const SparseMatrix& lower) : A_(lower.selfadjointView<Eigen::Lower>()) {
    A_.makeCompressed();
    const int n = static_cast<int>(A_.rows());
    void* symbolic = nullptr;
    require_ok(umfpack_di_symbolic(n, n, A_.outerIndexPtr(), A_.innerIndexPtr(), A_.valuePtr(), &symbolic,
                                   control_.data(), nullptr));
    const int status = umfpack_di_numeric(A_.outerIndexPtr(), A_.innerIndexPtr(), A_.valuePtr(), symbolic, &numeric_,
                                          control_.data(), info_.data());
    umfpack_di_free_symbolic(&symbolic);
    require_ok(status);
  }
  ~Factor() { umfpack_di_free_numeric(&numeric_); }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;

  bool is_symmetric() const { return info_[UMFPACK_NOFF_DIAG] == 0; }  // no pivot off the diagonal

  VectorXd pivots() const {
    VectorXd D(A_.rows());
    int reciprocal = 0;
    require_ok(umfpack_di_get_numeric(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, D.data(),
                                      &reciprocal, nullptr, numeric_));
    return D;
  }

  double residual_of_one_solve() const {
    const VectorXd b = uniform_noise(A_.rows(), 1);
    VectorXd x(b.size());
    require_ok(umfpack_di_solve(UMFPACK_A, A_.outerIndexPtr(), A_.innerIndexPtr(), A_.valuePtr(), x.data(), b.data(),
                                numeric_, control_.data(), nullptr));
    const VectorXd sums = A_.cwiseAbs() * VectorXd::Ones(b.size());
    const double relative = (A_ * x - b).lpNorm<Eigen::Infinity>() / (sums.maxCoeff() * x.lpNorm<Eigen::Infinity>());
    return std::isfinite(relative) ? relative : infinity;
  }

 private:
  SparseMatrix A_;  // both triangles
  std::array<double, UMFPACK_CONTROL> control_ = settings();
  std::array<double, UMFPACK_INFO> info_{};
  void* numeric_ = nullptr;
};

}  // namespace

Inertia inertia(const SparseMatrix& A) {
  require_factorisable(A);
  const Factor factor(A);
  Inertia result{0, 0, 0, infinity};
  for (const double d : factor.pivots()) ++(d < 0 ? result.negative : d > 0 ? result.positive : result.zero);
  if (factor.is_symmetric() && result.zero == 0) result.residual = factor.residual_of_one_solve();
  return result;
}

}  // namespace mb
