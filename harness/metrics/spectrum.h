// How much of a motion's kinetic energy lies above a frequency, from its velocity v = x':
//
//   share(f) = sum_(f_k > f) E_k / sum_k E_k,   E_k = sum_i w_i |DFT(h v_i)_k|^2,   h_n = sin^2(pi (n + 1/2) / N)
//
// so that waves count with (2 pi f)^2 |x|^2 and what stands still does not. Velocities are the N differences of x over
// a sample, whose lines are multiplied by y / sin(y), y = pi f_k / rate: that is the derivative of every wave exactly.
//
// The record is Hann-windowed and zero-padded to 2 N. The window weighs the middle of the record most and spreads a
// wave over four bins of 1/T: less than 1e-3 of its energy comes to lie further than 2/T from its frequency.
// Harris 1978, Proc. IEEE 66(1).
#pragma once

#include "mechanics/types.h"

namespace mb {

// x: signals in rows, equidistant times in columns; w >= 0, one a row; rate [1/s] > 0 samples a second; f [1/s] >= 0.
// In [0, 1]; NaN where x is not finite or nothing moves: no change over a sample exceeds 1e-12 of the largest |x|.
double energy_share_above(const MatrixXd& x, const VectorXd& w, double rate, double f);

}  // namespace mb
