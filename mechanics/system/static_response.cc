#include "mechanics/system/static_response.h"

#include <stdexcept>

#include "mechanics/algebra/pcg.h"

namespace mb {

ShiftedFactor shifted_factor(const System& system, double shift) {
  if (!(shift < 0)) throw std::invalid_argument("shifted_factor: the shift must be negative");
  SparseMatrix A = system.K - shift * system.M;
  A.makeCompressed();
  return {shift, Cholesky(A)};
}

MatrixXd without_rigid_part(const System& system, const MatrixXd& v) {
  if (system.R.cols() == 0) return v;
  return v - system.R * ((system.M * system.R).transpose() * v);
}

MatrixXd inertia_relief(const System& system, const ShiftedFactor& shifted, const MatrixXd& F) {
  if (F.rows() != system.K.rows()) throw std::invalid_argument("inertia_relief: loads and system differ in size");
  constexpr double tolerance = 1e-12;
  constexpr int max_iterations = 100;  // 3 to 10 are usual: the factor is that of K but for a small shift
  const MatrixXd MR = system.M * system.R;
  const LinearMap precondition = [&](const VectorXd& r) { return shifted.factor.solve(r); };
  const LinearMap project = [&](const VectorXd& v) -> VectorXd { return v - system.R * (MR.transpose() * v); };
  MatrixXd G_F = MatrixXd::Zero(F.rows(), F.cols());
  for (Index load = 0; load < F.cols(); ++load) {
    const VectorXd f = F.col(load) - MR * (system.R.transpose() * F.col(load));
    // Of a load that only moves the body as a whole f is rounding: nothing to solve.
    if (f.norm() <= tolerance * F.col(load).norm()) continue;
    const double relative = tolerance * F.col(load).norm() / f.norm();
    const PcgSolution solution = pcg(system.K, f, precondition, relative, max_iterations, project);
    G_F.col(load) = project(solution.x);
  }
  return G_F;
}

}  // namespace mb
