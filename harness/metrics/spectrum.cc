#include "harness/metrics/spectrum.h"

#include <limits>

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
  const MatrixXd windowed = change * (window / largest).asDiagonal();
  // E_k = a_k^T G a_k + b_k^T G b_k with a_k, b_k the samples of cosine and sine: the points are summed once, in G.
  const MatrixXd gram = windowed.transpose() * w.asDiagonal() * windowed;
  const VectorXd k = VectorXd::LinSpaced(n + 1, 0, static_cast<double>(n));  // frequency k rate / (2 n)
  const MatrixXd phase = pi / static_cast<double>(n) * sample * k.transpose();
  const MatrixXd a = phase.array().cos(), b = phase.array().sin();
  VectorXd energy = ((gram * a).cwiseProduct(a) + (gram * b).cwiseProduct(b)).colwise().sum();
  const VectorXd y = pi / (2 * static_cast<double>(n)) * k.tail(n);
  energy.tail(n).array() *= (y.array() / y.array().sin()).square();
  energy(0) /= 2;  // signals are real: every other frequency but the last stands for its mirror image too
  energy(n) /= 2;
  energy = energy.cwiseMax(0);  // rounding
  const auto is_above = (k.array() * (rate / (2 * static_cast<double>(n))) > f).cast<double>();
  return energy.dot(is_above.matrix()) / energy.sum();
}

}  // namespace mb
