#include "harness/metrics/band_split.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace mb {

namespace {

constexpr double half_width = 0.2;  // b

Index padded_length(Index n) { return static_cast<Index>(std::bit_ceil(static_cast<size_t>(4 * n))); }

MatrixXcd padded(const MatrixXd& x) {
  const Index n = x.cols(), N = padded_length(n);
  MatrixXcd whole = x.col(0).replicate(1, N).cast<std::complex<double>>();
  whole.leftCols(n) = x.cast<std::complex<double>>();
  for (Index j = 1; j < n; ++j) {
    const double fade = 0.5 * (1 + std::cos(pi * static_cast<double>(j) / static_cast<double>(n)));
    const VectorXd reflected = 2 * x.col(n - 1) - x.col(n - 1 - j);
    whole.col(n - 1 + j) += (fade * (reflected - x.col(0))).cast<std::complex<double>>();
  }
  return whole;
}

}  // namespace

double low_pass(double f, double f_c) {
  const double y = (f / f_c - 1) / half_width;
  if (y <= -1) return 1;
  return y >= 1 ? 0 : 0.5 * (1 - std::sin(pi / 2 * y));
}

PaddedSpectrum::PaddedSpectrum(const MatrixXd& x, double rate) : end_(static_cast<double>(x.cols() - 1) / rate) {
  if (x.cols() < 2 || !(rate > 0) || !std::isfinite(rate) || !x.allFinite())
    throw std::invalid_argument("a spectrum needs two finite samples at least and their rate");
  const Index half = padded_length(x.cols()) / 2;
  constexpr Index block = 16;  // signals at a time: padded, a record is some ten times as long
  X_.resize(x.rows(), half + 1);
  for (Index first = 0; first < x.rows(); first += block) {
    const Index n = std::min(block, x.rows() - first);
    X_.middleRows(first, n) =
        fourier(padded(x.middleRows(first, n))).leftCols(half + 1) / static_cast<double>(2 * half);
  }
  f_ = VectorXd::LinSpaced(half + 1, 0, rate / 2);
}

std::complex<double> PaddedSpectrum::one_sided(Index k, const Gain& gain) const {
  return (k == 0 || k == f_.size() - 1 ? 1.0 : 2.0) * gain(f_(k));
}

MatrixXd PaddedSpectrum::at(const VectorXd& t, const Gain& gain) const {
  for (const double time : t)
    if (!(time >= -1e-9 * end_ && time <= end_ * (1 + 1e-9))) throw std::invalid_argument("a time outside the record");
  constexpr Index most = 1024;  // frequencies at a time
  MatrixXd values = MatrixXd::Zero(X_.rows(), t.size());
  std::vector<Index> bins;
  const auto add = [&] {
    const auto n = static_cast<Index>(bins.size());
    MatrixXd parts(X_.rows(), 2 * n), waves(2 * n, t.size());
    for (Index j = 0; j < n; ++j) {
      const Index k = bins[static_cast<size_t>(j)];
      const Eigen::VectorXcd X = one_sided(k, gain) * X_.col(k);
      const Eigen::ArrayXd phase = 2 * pi * f_(k) * t.array();
      parts.col(j) = X.real();
      parts.col(n + j) = -X.imag();
      waves.row(j) = phase.cos().matrix().transpose();
      waves.row(n + j) = phase.sin().matrix().transpose();
    }
    values.noalias() += parts * waves;
    bins.clear();
  };
  for (Index k = 0; k < f_.size(); ++k) {
    if (gain(f_(k)) != 0.0) bins.push_back(k);
    if (static_cast<Index>(bins.size()) == most) add();
  }
  add();
  return values;
}

VectorXd PaddedSpectrum::mean_square(const Gain& gain) const {
  VectorXd sum = VectorXd::Zero(X_.rows());
  for (Index k = 0; k < f_.size(); ++k) {
    const double mirrored = k == 0 || k == f_.size() - 1 ? 1 : 2;
    sum += mirrored * std::norm(gain(f_(k))) * X_.col(k).cwiseAbs2();
  }
  return sum;
}

}  // namespace mb
