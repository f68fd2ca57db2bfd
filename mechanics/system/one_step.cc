#include "mechanics/system/one_step.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"

namespace mb {

namespace {

// y' = (0 S; -L -C) y with S = diag(s), L = K S^-1.
struct Scaled {
  MatrixXd S, L;
  const MatrixXd& C;
};

constexpr const char* lagged = "central-difference, lagged damping";

// Half a step apart they are the same.
bool kicks_by_old_rates(const std::string& scheme) { return scheme == "symplectic-euler" || scheme == lagged; }

// What of C is taken by the mean of both rates, where the rest of it lags.
MatrixXd by_mean(const CoupledModes& modes, const std::string& scheme) {
  const Index n = modes.K.rows();
  if (scheme == lagged && modes.by_mean.size() == n) return modes.by_mean.asDiagonal();
  return MatrixXd::Zero(n, n);
}

// Rates first, by the mean of both rates or by the old ones, then places by the new rates.
MatrixXd kick_and_drift(const Scaled& modes, const MatrixXd& implicit_mass, double h) {
  const Index n = modes.S.rows();
  const MatrixXd I = MatrixXd::Identity(n, n);
  const Eigen::LLT<MatrixXd> mass(implicit_mass);
  MatrixXd A(2 * n, 2 * n);
  A.bottomLeftCorner(n, n) = -h * mass.solve(modes.L);
  A.bottomRightCorner(n, n) = I - h * mass.solve(modes.C);
  A.topRows(n) = h * modes.S * A.bottomRows(n);
  A.topLeftCorner(n, n) += I;
  return A;
}

MatrixXd generator(const Scaled& modes) {
  const Index n = modes.S.rows();
  MatrixXd B = MatrixXd::Zero(2 * n, 2 * n);
  B.topRightCorner(n, n) = modes.S;
  B.bottomLeftCorner(n, n) = -modes.L;
  B.bottomRightCorner(n, n) = -modes.C;
  return B;
}

// 4 - 2 h C - h^2 K loses its definiteness once as h grows, between the limit without damping and the least that trace
// and norm allow.
double definite_step(const CoupledModes& modes, double undamped) {
  const MatrixXd four = 4 * MatrixXd::Identity(modes.K.rows(), modes.K.rows());
  const auto definite = [&](double h) {
    return Eigen::LLT<MatrixXd>(four - 2 * h * modes.C - h * h * modes.K).info() == Eigen::Success;
  };
  double low = std::min(undamped / 2, 1 / modes.C.norm()), high = undamped;
  while (high - low > 1e-9 * low) {
    const double middle = (low + high) / 2;
    (definite(middle) ? low : high) = middle;
  }
  return low;
}

// |1 + h mu|^2 = 1 + h (2 Re mu + h |mu|^2). Damping that is rounding is none.
double oscillating_step(const CoupledModes& modes) {
  constexpr double rounding = 1e-12;  // [-] of |mu|
  const Scaled scaled{energy_scales(modes.K, 1).asDiagonal(),
                      modes.K * energy_scales(modes.K, 1).cwiseInverse().asDiagonal(), modes.C};
  const Eigen::VectorXcd mu = general_eigenvalues(generator(scaled));
  const double largest = mu.cwiseAbs().maxCoeff();
  double step = std::numeric_limits<double>::infinity();
  for (const std::complex<double>& one : mu) {
    if (std::abs(one) <= 1e-7 * largest) continue;  // a rigid mode, twofold: stays where it is
    if (one.real() >= -rounding * std::abs(one)) return 0;
    step = std::min(step, -2 * one.real() / std::norm(one));
  }
  return step;
}

}  // namespace

VectorXd energy_scales(const MatrixXd& K, double h) {
  const VectorXd k = K.diagonal();
  return (k.array() > 0).select(k.cwiseSqrt(), 1 / h);
}

MatrixXd one_step(const CoupledModes& modes, const std::string& scheme, double h) {
  if (!(h > 0)) throw std::invalid_argument("one step: its length must be positive");
  const VectorXd s = energy_scales(modes.K, h);
  const Scaled scaled{s.asDiagonal(), modes.K * s.cwiseInverse().asDiagonal(), modes.C};
  const Index n = s.size();
  const MatrixXd I = MatrixXd::Identity(n, n);
  if (kicks_by_old_rates(scheme)) return kick_and_drift(scaled, I + h / 2 * by_mean(modes, scheme), h);
  if (scheme == "central-difference") return kick_and_drift(scaled, I + h / 2 * modes.C, h);
  const MatrixXd whole = MatrixXd::Identity(2 * n, 2 * n), B = generator(scaled);
  if (scheme == "explicit-euler") return whole + h * B;
  // Average acceleration is the trapezoidal rule of y' = B y.
  if (scheme == "newmark") return (whole - h / 2 * B).partialPivLu().solve(whole + h / 2 * B);
  throw std::invalid_argument("one step: scheme '" + scheme + "' has no matrix of coupled modes");
}

double stable_step(const CoupledModes& modes, const std::string& scheme) {
  const double infinity = std::numeric_limits<double>::infinity();
  if (scheme == "newmark" || modes.K.size() == 0) return infinity;
  if (scheme == "explicit-euler") return oscillating_step(modes);
  const double undamped = 2 / std::sqrt(symmetric_eigenvalues(modes.K).maxCoeff());
  if (scheme == "central-difference") return undamped;
  if (kicks_by_old_rates(scheme)) return definite_step({modes.K, modes.C - by_mean(modes, scheme)}, undamped);
  throw std::invalid_argument("stable step: scheme '" + scheme + "' has no matrix of coupled modes");
}

double spectral_radius(const MatrixXd& A) {
  if (A.size() == 0) return 0;
  if (!A.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  return general_eigenvalues(A).cwiseAbs().maxCoeff();
}

}  // namespace mb
