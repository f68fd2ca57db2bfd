#include "harness/metrics/spectrum.h"

#include <algorithm>
#include <limits>

#include "harness/metrics/fourier.h"

namespace mb {

double energy_share_above(const MatrixXd& x, const VectorXd& w, double rate, double f) {
  constexpr double rounding = 1e-12;  // [-] what stored trajectories keep of the values, see trajectory_file.h
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Index n = x.cols() - 1;
  if (x.rows() == 0 || n < 1) return nan;
  const MatrixXd change = x.rightCols(n) - x.leftCols(n);
  const double largest = change.cwiseAbs().maxCoeff();
  if (!change.allFinite() || !(largest > rounding * x.cwiseAbs().maxCoeff())) return nan;

  const VectorXd sample = VectorXd::LinSpaced(n, 0, static_cast<double>(n - 1));
  const VectorXd window = (pi / static_cast<double>(n) * (sample.array() + 0.5)).sin().square();
  VectorXd energy = VectorXd::Zero(n + 1);
  constexpr Index block = 16;  // signals at a time: their spectra together are twice as long as all records
  for (Index first = 0; first < x.rows(); first += block) {
    const Index n_rows = std::min(block, x.rows() - first);
    const MatrixXd windowed = change.middleRows(first, n_rows) * (window / largest).asDiagonal();
    energy += real_fourier(windowed, 2 * n).cwiseAbs2().transpose() * w.segment(first, n_rows);
  }
  const VectorXd k = VectorXd::LinSpaced(n + 1, 0, static_cast<double>(n));  // frequency k rate / (2 n)
  const VectorXd y = pi / (2 * static_cast<double>(n)) * k.tail(n);
  energy.tail(n).array() *= (y.array() / y.array().sin()).square();
  energy(0) /= 2;  // signals are real: every other frequency but the last stands for its mirror image too
  energy(n) /= 2;
  const auto is_above = (k.array() * (rate / (2 * static_cast<double>(n))) > f).cast<double>();
  return energy.dot(is_above.matrix()) / energy.sum();
}

}  // namespace mb
