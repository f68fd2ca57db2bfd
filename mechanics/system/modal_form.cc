#include "mechanics/system/modal_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/symmetric_product.h"

namespace mb {
namespace {

constexpr Index largest_dense = 6000;
constexpr double decoupled = 1e-8;  // [-] coupling by damping that counts as rounding: modes are known to about that

// Largest |lambda| of a rigid mode. Theory is 0, a dense solver leaves a few eps lambda_max; 1e-9 of the lowest elastic
// eigenvalue is a rigid mode whatever the solver. Throws where the number of rigid modes is not n_rigid.
double rigid_bound(VectorXd lambda, Index n_rigid) {
  if (lambda.size() == 0) return 0;
  std::sort(lambda.begin(), lambda.end());
  const double lowest_elastic = n_rigid < lambda.size() ? lambda[n_rigid] : 0;
  const double rounding = 50 * std::numeric_limits<double>::epsilon() * lambda.cwiseAbs().maxCoeff();
  const double bound = std::max(1e-9 * lowest_elastic, rounding);
  if (!(lambda[0] >= -bound))
    throw std::runtime_error(fmt::format("K is not semi-definite: eigenvalue {:.6g}", lambda[0]));
  const auto n_zero = (lambda.array() <= bound).count();
  if (n_zero != n_rigid)
    throw std::runtime_error(fmt::format(
        "{} eigenvalues are zero (|lambda| <= {:.3g}), but the system states {} rigid modes", n_zero, bound, n_rigid));
  return bound;
}

// Phi^T C Phi as far as it is diagonal, and the largest entry that is not, relative to the larger of its diagonals.
struct ModalCoefficients {
  VectorXd c;
  double coupling = 0;  // [-]
};

// lambda exactly 0 for rigid modes. G = Phi^T W: n x number of modes with ratios of their own.
ModalCoefficients coefficients(const VectorXd& lambda, const MatrixXd& G, const System& system) {
  const auto [alpha, beta] = system.damping;
  const VectorXd& d = system.modal_damping.d;
  ModalCoefficients result{(lambda.array() > 0).select(alpha + beta * lambda.array(), 0)};
  if (d.size() == 0) return result;
  const VectorXd own = G.cwiseAbs2() * d, size = result.c + G.cwiseAbs2() * d.cwiseAbs();
  const double rounding = 1e-13 * d.cwiseAbs().maxCoeff();  // of an entry of G: a few hundred eps
  // Ratios may take Rayleigh damping back: what is left below 0 is then rounding.
  result.c += own;
  for (Index i = 0; i < lambda.size(); ++i)
    if ((result.c[i] < 0 && -result.c[i] <= decoupled * size[i]) ||
        (lambda[i] == 0 && std::abs(result.c[i]) <= rounding))
      result.c[i] = 0;
  VectorXd column(lambda.size());
  for (Index j = 0; j < lambda.size(); ++j) {
    column.noalias() = G * d.cwiseProduct(G.row(j).transpose());
    for (Index i = j + 1; i < lambda.size(); ++i) {
      const double coupling = std::abs(column[i]) / std::max({result.c[i], result.c[j], rounding});
      if (std::abs(column[i]) > rounding) result.coupling = std::max(result.coupling, coupling);
    }
  }
  return result;
}

// Within frequencies that repeat any M-orthonormal basis will do: takes the one in which the damping is diagonal.
void rotate_repeated(const VectorXd& lambda, const System& system, MatrixXd& Phi) {
  const auto& [W, d] = system.modal_damping;
  // Between equal ones a dense solver leaves a few eps lambda_max, and a hundredth of 1e-10 whatever the spectrum.
  const double rounding = 50 * std::numeric_limits<double>::epsilon() * lambda.maxCoeff();
  const auto differ = [&](double a, double b) { return b - a > std::max(1e-10 * a, rounding); };
  for (Index first = 0, count = 0; first < lambda.size(); first += count) {
    for (count = 1; first + count < lambda.size(); ++count)
      if (lambda[first] == 0 || differ(lambda[first], lambda[first + count])) break;
    if (count == 1) continue;
    auto repeated = Phi.middleCols(first, count);
    const MatrixXd G = repeated.transpose() * W;
    const EigenPairs among = symmetric_eigen(G * d.asDiagonal() * G.transpose());
    repeated = (repeated * among.vectors).eval();
  }
}

VectorXd without_rounding(VectorXd lambda, Index n_rigid) {
  const double bound = rigid_bound(lambda, n_rigid);
  return (lambda.array() <= bound).select(0, lambda);
}

ModalForm dense(const System& system) {
  const Index n = system.M.rows(), n_rigid = system.R.cols();
  if (n > largest_dense)
    throw std::invalid_argument(fmt::format("{} unknowns: a dense eigenproblem is limited to {}", n, largest_dense));
  auto eigen = generalized_eigen(MatrixXd(system.K), MatrixXd(system.M));
  if (!eigen) throw std::invalid_argument("the mass matrix is not positive definite");
  MatrixXd Phi = std::move(eigen->vectors);
  if (n_rigid > 0) {
    Phi.leftCols(n_rigid) = system.R;
    auto elastic = Phi.rightCols(n - n_rigid);
    elastic -= system.R * ((system.M * system.R).transpose() * elastic);
  }
  VectorXd lambda = without_rounding(std::move(eigen->values), n_rigid);
  if (system.modal_damping.d.size() > 0) rotate_repeated(lambda, system, Phi);
  const MatrixXd G =
      system.modal_damping.d.size() > 0 ? MatrixXd(Phi.transpose() * system.modal_damping.W) : MatrixXd();
  ModalCoefficients damping = coefficients(lambda, G, system);
  if (damping.coupling <= decoupled) return {std::move(lambda), std::move(damping.c), std::move(Phi)};
  const auto [alpha, beta] = system.damping;
  MatrixXd C = G * system.modal_damping.d.asDiagonal() * G.transpose();
  C.diagonal() += VectorXd((lambda.array() > 0).select(alpha + beta * lambda.array(), 0));
  return {std::move(lambda), std::move(damping.c), std::move(Phi), std::move(C)};
}

}  // namespace

ModalForm modal_form(const System& system) {
  require_consistent(system);
  if (system.viscous.rows() > 0)
    throw std::invalid_argument("modal form: damping of bodies side by side is not that of modes");
  if (is_diagonal(system.M) && is_diagonal(system.K) && (VectorXd(system.M.diagonal()).array() == 1).all()) {
    VectorXd lambda = without_rounding(system.K.diagonal(), system.R.cols());
    ModalCoefficients damping = coefficients(lambda, system.modal_damping.W, system);
    if (damping.coupling <= decoupled) return {std::move(lambda), std::move(damping.c), MatrixXd()};
  }
  return dense(system);
}

}  // namespace mb
