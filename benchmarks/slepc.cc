#include "benchmarks/slepc.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#ifdef MB_HAS_SLEPC
#include <slepceps.h>
#endif

namespace mb {

#ifdef MB_HAS_SLEPC

namespace {

static_assert(sizeof(PetscInt) == sizeof(int) && sizeof(PetscScalar) == sizeof(double));

void require(PetscErrorCode code, const char* what) {
  if (code != 0) throw std::runtime_error(std::string("SLEPc: ") + what);
}

// A symmetric matrix by columns is the same by rows; the arrays are shared, not copied.
Mat shared(const SparseMatrix& A) {
  Mat matrix = nullptr;
  const int n = static_cast<int>(A.rows());
  require(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, const_cast<int*>(A.outerIndexPtr()),
                                    const_cast<int*>(A.innerIndexPtr()), const_cast<double*>(A.valuePtr()), &matrix),
          "matrix");
  require(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE), "symmetry");
  return matrix;
}

struct Release {
  void operator()(Mat matrix) const { MatDestroy(&matrix); }
  void operator()(EPS solver) const { EPSDestroy(&solver); }
};
template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

void shift_invert_by_mumps(EPS solver, double sigma) {
  ST transform = nullptr;
  KSP linear = nullptr;
  PC factor = nullptr;
  require(EPSSetTarget(solver, sigma), "target");
  require(EPSSetWhichEigenpairs(solver, EPS_TARGET_MAGNITUDE), "target");
  require(EPSGetST(solver, &transform), "transform");
  require(STSetType(transform, STSINVERT), "transform");
  require(STGetKSP(transform, &linear), "linear solver");
  require(KSPSetType(linear, KSPPREONLY), "linear solver");
  require(KSPGetPC(linear, &factor), "factor");
  require(PCSetType(factor, PCCHOLESKY), "factor");
  require(PCFactorSetMatSolverType(factor, MATSOLVERMUMPS), "MUMPS");
}

}  // namespace

SlepcSession::SlepcSession(int* argc, char*** argv) {
  require(SlepcInitialize(argc, argv, nullptr, nullptr), "initialisation");
}
SlepcSession::~SlepcSession() { SlepcFinalize(); }

VectorXd SlepcSession::nearest(const SparseMatrix& K, const SparseMatrix& M, int n_wanted, double sigma,
                               double tolerance) const {
  const Owned<Mat> stiffness(shared(K)), mass(shared(M));
  EPS handle = nullptr;
  require(EPSCreate(PETSC_COMM_SELF, &handle), "solver");
  const Owned<EPS> solver(handle);
  require(EPSSetOperators(handle, stiffness.get(), mass.get()), "operators");
  require(EPSSetProblemType(handle, EPS_GHEP), "problem type");
  require(EPSSetType(handle, EPSKRYLOVSCHUR), "method");
  require(EPSSetDimensions(handle, n_wanted, PETSC_DEFAULT, PETSC_DEFAULT), "dimensions");
  require(EPSSetTolerances(handle, tolerance, PETSC_DEFAULT), "tolerance");
  shift_invert_by_mumps(handle, sigma);
  require(EPSSetFromOptions(handle), "options");  // of the command line: -eps_ncv 90
  require(EPSSolve(handle), "solution");
  int n_converged = 0;
  require(EPSGetConverged(handle, &n_converged), "convergence");
  if (n_converged < n_wanted) throw std::runtime_error("SLEPc: no convergence");
  VectorXd lambda(n_wanted);
  for (int i = 0; i < n_wanted; ++i)
    require(EPSGetEigenpair(handle, i, &lambda[i], nullptr, nullptr, nullptr), "eigenvalue");
  std::sort(lambda.begin(), lambda.end());
  return lambda;
}

bool has_slepc() { return true; }

#else

SlepcSession::SlepcSession(int*, char***) {}
SlepcSession::~SlepcSession() = default;
VectorXd SlepcSession::nearest(const SparseMatrix&, const SparseMatrix&, int, double, double) const {
  throw std::runtime_error("built without SLEPc");
}
bool has_slepc() { return false; }

#endif

}  // namespace mb
