#include "harness/metrics/fourier.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <utility>

namespace mb {

namespace {

using Complex = std::complex<double>;

void reverse_bits(MatrixXcd& x) {
  const Index n = x.cols();
  for (Index i = 1, j = 0; i < n; ++i) {
    Index bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) x.col(i).swap(x.col(j));
  }
}

void transform(MatrixXcd& x) {
  const Index n = x.cols();
  reverse_bits(x);
  Eigen::VectorXcd odd(x.rows());
  for (Index half = 1; half < n; half *= 2)
    for (Index k = 0; k < half; ++k) {  // every angle afresh: products of rotations would gather rounding
      const Complex twiddle = std::polar(1.0, -pi * static_cast<double>(k) / static_cast<double>(half));
      for (Index i = k; i < n; i += 2 * half) {
        odd = twiddle * x.col(i + half);
        x.col(i + half) = x.col(i) - odd;
        x.col(i) += odd;
      }
    }
}

}  // namespace

MatrixXcd fourier(MatrixXcd x) {
  const Index n = x.cols();
  if (n < 1 || (n & (n - 1)) != 0) throw std::invalid_argument("a Fourier transform needs a power of two of samples");
  constexpr Index block = 16;  // signals at a time: a long record of them stays in the cache
  for (Index first = 0; first < x.rows(); first += block) {
    auto rows = x.middleRows(first, std::min(block, x.rows() - first));
    MatrixXcd part = rows;
    transform(part);
    rows = part;
  }
  return x;
}

MatrixXcd real_fourier(const MatrixXd& x, Index N) {
  const Index n = x.cols(), n_bins = N / 2 + 1;
  if (n < 1 || N < n || N % 2 != 0) throw std::invalid_argument("a Fourier transform of an even number of samples");
  const auto length = static_cast<Index>(std::bit_ceil(static_cast<size_t>(n + n_bins - 1)));
  const auto chirp = [N](Index k) {  // k^2 modulo 2 N: large angles would lose digits
    const double square = std::fmod(static_cast<double>(k) * static_cast<double>(k), 2 * static_cast<double>(N));
    return std::polar(1.0, -pi * square / static_cast<double>(N));
  };
  MatrixXcd kernel = MatrixXcd::Zero(1, length);
  for (Index k = 0; k < n_bins; ++k) kernel(0, k) = std::conj(chirp(k));
  for (Index k = 1; k < n; ++k) kernel(0, length - k) = std::conj(chirp(k));
  kernel = fourier(kernel);

  MatrixXcd part = MatrixXcd::Zero(x.rows(), length);
  for (Index k = 0; k < n; ++k) part.col(k) = chirp(k) * x.col(k);
  part = fourier(std::move(part));
  for (Index k = 0; k < length; ++k) part.col(k) *= kernel(0, k);
  part = fourier(part.conjugate());  // the inverse, conjugated and times its length
  MatrixXcd X(x.rows(), n_bins);
  for (Index k = 0; k < n_bins; ++k) X.col(k) = chirp(k) / static_cast<double>(length) * part.col(k).conjugate();
  return X;
}

}  // namespace mb
