#include "harness/metrics/fourier.h"

#include <algorithm>
#include <complex>
#include <stdexcept>

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

}  // namespace mb
