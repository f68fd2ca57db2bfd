// Discrete Fourier transform of many signals at once,
//
//   X_k = sum_n x_n e^{-2 pi i k n / N},   N a power of two
//
// by radix-2 decimation in time (Cooley & Tukey 1965, Math. Comp. 19), of other N as a convolution of such lengths,
// since 2 n k = n^2 + k^2 - (k - n)^2 (Bluestein 1970, IEEE Trans. Audio Electroacoust. 18).
#pragma once

#include "mechanics/types.h"

namespace mb {

using MatrixXcd = Eigen::MatrixXcd;

// x: one signal a row, N columns. Throws std::invalid_argument where N is not a power of two.
MatrixXcd fourier(MatrixXcd x);

// X_0 ... X_{N/2} of real signals, zero behind their columns; N >= x.cols() even, else std::invalid_argument. Takes
// some ten times their memory: many are best taken a few at a time.
MatrixXcd real_fourier(const MatrixXd& x, Index N);

}  // namespace mb
