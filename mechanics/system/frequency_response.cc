#include "mechanics/system/frequency_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include "mechanics/algebra/noise.h"
#include "mechanics/system/low_rank_damping.h"
#include "mechanics/system/symmetric_product.h"

namespace mb {
namespace {

using Eigen::MatrixXcd;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr Complex i(0, 1);
constexpr double worst_condition = 0.01 / std::numeric_limits<double>::epsilon();  // [-] beyond it two digits are lost

// Coefficients of (1 + i omega beta) K + (-omega^2 + i omega alpha) M.
struct Coefficients {
  Complex K, M;
};
Coefficients coefficients(const Rayleigh& damping, double omega) {
  return {1.0 + i * omega * damping.beta, -omega * omega + i * omega * damping.alpha};
}

// Entry by entry; low_rank: V diag(e) V^T where that is diagonal, or empty.
class Diagonal {
 public:
  Diagonal(const System& system, VectorXd low_rank)
      : damping_(system.damping), K_(system.K.diagonal()), M_(system.M.diagonal()), low_rank_(std::move(low_rank)) {
    if (low_rank_.size() == 0) low_rank_ = VectorXd::Zero(K_.size());
  }
  void factorise(double omega) {
    constexpr double singular = 1e-14;  // of the larger term: their difference keeps fewer than two digits
    const auto [c_K, c_M] = coefficients(damping_, omega);
    Z_ = c_K * K_ + c_M * M_ + i * omega * low_rank_;
    for (Index j = 0; j < Z_.size(); ++j)
      if (!(std::abs(Z_[j]) > singular * std::max(K_[j], omega * omega * M_[j])))
        throw std::runtime_error(fmt::format("undamped resonance of unknown {}", j));
  }
  MatrixXcd solve(const MatrixXcd& b) const { return Z_.cwiseInverse().asDiagonal() * b; }
  double norm() const { return 0; }  // each entry has been looked at by itself

 private:
  Rayleigh damping_;
  VectorXd K_, M_, low_rank_;
  VectorXcd Z_;
};

// Damping of low rank, i omega W diag(d) W^T, as a border of a sparse matrix, which Woodbury's formula would eliminate:
//
//   [ A            sqrt(omega) W g ] [u]   [b]
//   [ sqrt(omega) g W^T   i k s    ] [y] = [0],     g = sqrt(k |d|),  s = 1 or -1 with d,  k [N/m] the mean diagonal of
//   K
//
// The border stays regular at the resonance of a mode which nothing but its own ratio damps, where A is singular.
class Bordered {
 public:
  // With every part stored in the pattern of all, a frequency's matrix is a combination of arrays.
  Bordered(const System& system, const ModalDamping& damping)
      : damping_(system.damping), n_(system.K.rows()), n_all_(n_ + damping.d.size()) {
    const auto& [W, d] = damping;
    const double k = system.K.diagonal().mean();
    Triplets border, corner;
    for (Index j = 0; j < d.size(); ++j) {
      const double g = std::sqrt(k * std::abs(d[j]));
      for (Index row = 0; row < n_; ++row) {
        if (W(row, j) == 0) continue;
        border.emplace_back(row, n_ + j, g * W(row, j));
        border.emplace_back(n_ + j, row, g * W(row, j));
      }
      corner.emplace_back(n_ + j, n_ + j, d[j] < 0 ? -k : k);
    }
    const SparseMatrix K = resized(system.K), M = resized(system.M), B = of(border), C = of(corner);
    const SparseMatrix all = K + M + B + C;
    K_ = K + 0 * all, M_ = M + 0 * all, border_ = B + 0 * all, corner_ = C + 0 * all;
    Z_ = all.cast<Complex>();
  }

  void factorise(double omega) {
    const auto [c_K, c_M] = coefficients(damping_, omega);
    Z_.coeffs() = c_K * K_.coeffs() + c_M * M_.coeffs() + std::sqrt(omega) * border_.coeffs() + i * corner_.coeffs();
    if (lu_)
      lu_->refactor(Z_);
    else
      lu_.emplace(Z_);
  }
  MatrixXcd solve(const MatrixXcd& b) const {
    MatrixXcd x(n_, b.cols());
    VectorXcd right = VectorXcd::Zero(n_all_);
    for (Index column = 0; column < b.cols(); ++column) {
      right.head(n_) = b.col(column);
      x.col(column) = lu_->solve(right).head(n_);
    }
    return x;
  }
  double norm() const {  // [N/m] the largest column's sum, border included
    double largest = 0;
    for (Index j = 0; j < n_; ++j) largest = std::max(largest, Z_.col(j).cwiseAbs().sum());
    return largest;
  }

 private:
  SparseMatrix of(const Triplets& entries) const {
    SparseMatrix A(n_all_, n_all_);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
  }
  SparseMatrix resized(SparseMatrix A) const {
    A.conservativeResize(n_all_, n_all_);
    return A;
  }

  Rayleigh damping_;
  Index n_, n_all_;
  SparseMatrix K_, M_, border_, corner_;
  SparseMatrixXcd Z_;
  std::optional<ComplexLu> lu_;
};

std::variant<Diagonal, Bordered> dynamic_stiffness(const System& system) {
  const LowRankDamping low_rank(0, MatrixXd(), system.modal_damping);
  if (is_diagonal(system.M) && is_diagonal(system.K) && low_rank.rank() == 0)
    return Diagonal(system, low_rank.diagonal());
  return Bordered(system, system.modal_damping);
}

void check(const System& system) {
  require_consistent(system);
  if (system.viscous.rows() > 0) throw std::invalid_argument("frequency response: of one body alone");
  const MatrixXd& W = system.modal_damping.W;
  // R^T W = R^T M Phi is 0 for elastic modes, at most 1 for what is M-orthonormal.
  if (system.R.cols() > 0 && W.cols() > 0 && !((system.R.transpose() * W).cwiseAbs().maxCoeff() <= 1e-6))
    throw std::invalid_argument("frequency_response: the damping of modes is to leave rigid motion alone");
}

}  // namespace

struct FrequencyResponse::Stiffness {
  std::variant<Diagonal, Bordered> of;

  void factorise(double omega) {
    std::visit([&](auto& matrix) { matrix.factorise(omega); }, of);
  }
  MatrixXcd solve(const MatrixXcd& b) const {
    return std::visit([&](const auto& matrix) { return matrix.solve(b); }, of);
  }
  double norm() const {
    return std::visit([](const auto& matrix) { return matrix.norm(); }, of);
  }
};

// |Z| |Z^-1| in the complement of rigid motion, by two steps of the power method from noise. Pivots would tell less: at
// the resonance of a mesh the smallest is the eigenvalue that vanishes over what the mode has of one unknown, squared.
double FrequencyResponse::condition() const {
  VectorXcd x = uniform_noise(system_.K.rows(), 1).cast<Complex>();
  for (int step = 0; step < 2; ++step) {
    const VectorXcd force = x - MR_ * (system_.R.transpose() * x);
    x = stiffness_->solve(force.normalized());
    x -= system_.R * (MR_.transpose() * x);
  }
  return stiffness_->norm() * x.norm();
}

FrequencyResponse::FrequencyResponse(const System& system) : system_(system) {
  check(system);
  const MatrixXd shares = system.R.transpose() * system.F;
  MR_ = system.M * system.R;
  rigid_ = system.R * shares;
  elastic_ = (system.F - MR_ * shares).cast<Complex>();
  stiffness_ = std::make_unique<Stiffness>(Stiffness{dynamic_stiffness(system)});
}
FrequencyResponse::~FrequencyResponse() = default;
FrequencyResponse::FrequencyResponse(FrequencyResponse&&) noexcept = default;

// The rigid part f_R = M R R^T f answers with -R R^T f / omega^2, whatever alpha; the rest is solved for in the
// M-orthogonal complement, where M - M R R^T M is M. Projected on both sides, for K - omega^2 M is all but singular in
// R at low frequencies.
MatrixXcd FrequencyResponse::operator()(double omega) {
  if (!(omega > 0 && std::isfinite(omega)))
    throw std::invalid_argument("frequency_response: frequencies must be positive");
  MatrixXcd u;
  try {
    stiffness_->factorise(omega);
    const double cond = condition();
    if (!(cond <= worst_condition)) throw std::runtime_error(fmt::format("undamped resonance, condition {:.1e}", cond));
    u = stiffness_->solve(elastic_);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("frequency_response at {:.6g} rad/s: {}", omega, error.what()));
  }
  u -= system_.R * (MR_.transpose() * u) + rigid_ / (omega * omega);
  return u;
}

MatrixXcd frequency_response(const System& system, Index load, const VectorXd& omega) {
  if (!(load >= 0 && load < system.F.cols()))
    throw std::invalid_argument(fmt::format("frequency_response: no load {} among {}", load, system.F.cols()));
  FrequencyResponse response(system);
  MatrixXcd u(system.F.rows(), omega.size());
  for (Index j = 0; j < omega.size(); ++j) u.col(j) = response(omega[j]).col(load);
  return u;
}

}  // namespace mb
