#include "harness/metrics/spectrum.h"

#include <limits>

namespace mb {

double energy_share_above(const MatrixXd& x, const VectorXd& w, double rate, double f) {
  const double largest = x.size() > 0 ? x.cwiseAbs().maxCoeff() : 0;
  if (!x.allFinite() || !(largest > 0)) return std::numeric_limits<double>::quiet_NaN();

  const Index n = x.cols();
  const VectorXd sample = VectorXd::LinSpaced(n, 0, static_cast<double>(n - 1));
  const VectorXd window = (pi / static_cast<double>(n) * (sample.array() + 0.5)).sin().square();
  const MatrixXd windowed = x * (window / largest).asDiagonal();
  // E_k = a_k^T G a_k + b_k^T G b_k with a_k, b_k the samples of cosine and sine: the points are summed once, in G.
  const MatrixXd gram = windowed.transpose() * w.asDiagonal() * windowed;
  const VectorXd k = VectorXd::LinSpaced(n + 1, 0, static_cast<double>(n));  // frequency k rate / (2 n)
  const MatrixXd phase = pi / static_cast<double>(n) * sample * k.transpose();
  const MatrixXd a = phase.array().cos(), b = phase.array().sin();
  VectorXd energy = ((gram * a).cwiseProduct(a) + (gram * b).cwiseProduct(b)).colwise().sum();
  energy(0) /= 2;  // signals are real: every other frequency but the last stands for its mirror image too
  energy(n) /= 2;
  const auto is_above = (k.array() * (rate / (2 * static_cast<double>(n))) > f).cast<double>();
  return energy.dot(is_above.matrix()) / energy.sum();
}

}  // namespace mb
