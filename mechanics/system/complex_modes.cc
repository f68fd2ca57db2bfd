#include "mechanics/system/complex_modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/exp_difference.h"

namespace mb {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr Index most_modes = 1000;  // a dense solver of 2000 unknowns takes a minute
constexpr double critical = 1e8;    // [-] condition beyond which half of the digits are lost
constexpr double driven = 1e-8;     // [-] of the largest |mu|: growth beyond rounding
constexpr Complex imaginary(0, 1), nought(0, 0);

void require_modes(const VectorXd& omega, const MatrixXd& C) {
  const Index n = omega.size();
  if (C.rows() != n || C.cols() != n) throw std::invalid_argument("complex modes: sizes of omega and C differ");
  if (n > most_modes)
    throw std::invalid_argument(
        fmt::format("complex modes of {} modes that damping couples: at most {}", n, most_modes));
  if (n > 0 && !(omega.minCoeff() > 0 && omega.allFinite()))
    throw std::invalid_argument("complex modes: damping couples a rigid mode, whose frequency is 0");
}

// Response at tau of z' = mu z + s, z(0) = 0; with `total` its integral over [0, tau], for one more node at 0.
Complex forced(Complex mu, const Segment& s, double tau, bool total) {
  const Complex a = mu * tau, w = imaginary * s.omega * tau;
  Complex sum = 0;
  if (s.c0 != 0) sum += s.c0 * tau * (total ? tau * exp_difference(a, nought, nought) : exp_difference(a, nought));
  if (s.c1 != 0) {
    const Complex line = total ? tau * exp_difference(a, nought, nought, nought) : exp_difference(a, nought, nought);
    sum += s.c1 * tau * tau * line;
  }
  if (s.a == 0 && s.b == 0) return sum;
  // a cos + b sin = p e^(i w) + conj(p) e^(-i w), p = (a - i b)/2
  const Complex p(0.5 * s.a, -0.5 * s.b);
  const auto wave = [&](Complex at) { return total ? tau * exp_difference(a, at, nought) : exp_difference(a, at); };
  return sum + tau * (p * wave(w) + std::conj(p) * wave(-w));
}

}  // namespace

ComplexModes complex_modes(const VectorXd& omega, const MatrixXd& C) {
  require_modes(omega, C);
  const Index n = omega.size();
  if (n == 0) return {VectorXcd(0), MatrixXcd(0, 0), 1};
  MatrixXd A = MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).diagonal() = omega;
  A.bottomLeftCorner(n, n).diagonal() = -omega;
  A.bottomRightCorner(n, n) = -C;
  const Eigen::EigenSolver<MatrixXd> solver(A);
  if (solver.info() != Eigen::Success) throw std::runtime_error("complex modes: the dense solver has not converged");
  const VectorXcd mu = solver.eigenvalues();
  std::vector<Index> order(static_cast<size_t>(2 * n));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Index i) { return std::pair(std::abs(mu[i]), -mu[i].imag()); });
  ComplexModes modes{mu(order), solver.eigenvectors()(Eigen::all, order), 1};
  if (const double growth = modes.mu.real().maxCoeff(); growth > driven * modes.mu.cwiseAbs().maxCoeff())
    throw std::runtime_error(
        fmt::format("complex modes: one grows by {:.3g} 1/s, C drives instead of damping", growth));
  const VectorXd s = singular_values(modes.X);
  modes.condition = s[0] / s[2 * n - 1];
  if (!(modes.condition <= critical))
    throw std::runtime_error(fmt::format(
        "complex modes: condition {:.1e} of the modes, two of them are critical to working precision: no closed form",
        modes.condition));
  return modes;
}

CoupledMotion::CoupledMotion(const VectorXd& omega, const MatrixXd& C, const MatrixXd& f, const VectorXd& q0,
                             const VectorXd& v0, std::vector<Piece> pieces)
    : omega_(omega), modes_(complex_modes(omega, C)), pieces_(std::move(pieces)) {
  const Index n = omega.size();
  const Eigen::PartialPivLU<MatrixXcd> X(modes_.X);
  MatrixXcd y = MatrixXcd::Zero(2 * n, f.cols() + 2);
  y.bottomLeftCorner(n, f.cols()) = f.cast<Complex>();
  y.rightCols(2).topRows(n).colwise() = omega.cwiseProduct(q0).cast<Complex>().eval();
  y.bottomRightCorner(n, 1) = v0.cast<Complex>();
  const MatrixXcd z = n > 0 ? MatrixXcd(X.solve(y)) : y;
  f_ = z.leftCols(f.cols());
  z_rest_ = z.col(f.cols());
  starts_.push_back(z.col(f.cols() + 1));
  for (size_t p = 0; p + 1 < pieces_.size(); ++p)
    starts_.push_back(after(pieces_[p], starts_.back(), pieces_[p].end - pieces_[p].start));
}

VectorXcd CoupledMotion::after(const Piece& piece, const VectorXcd& z, double tau) const {
  VectorXcd result = (tau * modes_.mu.array()).exp() * z.array();
  for (Index l = 0; l < f_.cols(); ++l)
    for (Index j = 0; j < result.size(); ++j)
      if (f_(j, l) != 0.0)
        result[j] += f_(j, l) * forced(modes_.mu[j], piece.loads[static_cast<size_t>(l)], tau, false);
  return result;
}

VectorXcd CoupledMotion::integral(const Piece& piece, const VectorXcd& z, double from, double to) const {
  const double tau = to - from;
  VectorXcd result(z.size());
  for (Index j = 0; j < z.size(); ++j) result[j] = tau * exp_difference(tau * modes_.mu[j], nought) * z[j];
  for (Index l = 0; l < f_.cols(); ++l) {
    const Segment s = rebased(piece.loads[static_cast<size_t>(l)], from, to);
    for (Index j = 0; j < z.size(); ++j) result[j] += f_(j, l) * forced(modes_.mu[j], s, tau, true);
  }
  return result;
}

void CoupledMotion::write(const VectorXcd& z, Index j, ModalStates& states) const {
  const Index n = omega_.size();
  const VectorXd y = (modes_.X * z).real();
  states.q.col(j) = y.head(n).cwiseQuotient(omega_);
  states.v.col(j) = y.tail(n);
  states.work.steps += n;
}

ModalStates CoupledMotion::states(const VectorXd& times) const {
  ModalStates states{MatrixXd(omega_.size(), times.size()), MatrixXd(omega_.size(), times.size()), {}};
  size_t p = 0;
  for (Index j = 0; j < times.size(); ++j) {
    while (p + 1 < pieces_.size() && pieces_[p].end <= times[j]) ++p;
    write(after(pieces_[p], starts_[p], times[j] - pieces_[p].start), j, states);
  }
  states.work.load_evaluations = static_cast<long>(f_.cols() * static_cast<Index>(p + 1));
  return states;
}

ModalStates CoupledMotion::means(const VectorXd& times, double width) const {
  ModalStates states{MatrixXd(omega_.size(), times.size()), MatrixXd(omega_.size(), times.size()), {}};
  for (Index j = 0; j < times.size(); ++j) {
    const double first = times[j] - width / 2, last = times[j] + width / 2;
    VectorXcd sum = std::max(0.0, -first) * z_rest_;
    for (size_t p = 0; p < pieces_.size(); ++p) {
      const bool is_last = p + 1 == pieces_.size();  // t = n dt may pass the duration by an ulp
      const double from = std::max(first, pieces_[p].start), to = is_last ? last : std::min(last, pieces_[p].end);
      if (from >= to) continue;
      sum += integral(pieces_[p], after(pieces_[p], starts_[p], from - pieces_[p].start), from, to);
      states.work.load_evaluations += static_cast<long>(f_.cols());
    }
    write(sum / width, j, states);
  }
  return states;
}

}  // namespace mb
