// Discrete Fourier transform of many signals at once,
//
//   X_k = sum_n x_n e^{-2 pi i k n / N},   N a power of two
//
// by radix-2 decimation in time. Cooley & Tukey 1965, Math. Comp. 19.
#pragma once

#include "mechanics/types.h"

namespace mb {

using MatrixXcd = Eigen::MatrixXcd;

// x: one signal a row, N columns. Throws std::invalid_argument where N is not a power of two.
MatrixXcd fourier(MatrixXcd x);

}  // namespace mb
