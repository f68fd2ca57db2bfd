// A record taken apart at a frequency without any shift in time, x = x_low + x_high:
//
//   x(t) = sum_k X_k e^{2 pi i f_k t},   x_low = sum_k H(f_k) X_k e^{2 pi i f_k t}
//   H(f) = 1 for f <= (1 - b) f_c;   1/2 (1 - sin(pi/2 (f/f_c - 1)/b));   0 for f >= (1 + b) f_c;   b = 0.2
//
// H is real, hence of zero phase; its raised cosine lets the filter's memory fade as 1/t^3 beyond 1/(2 b f_c). X_k are
// those of a padded record of N >= 4 n samples: before its start the record rests at its first value, as bodies do;
// after its end it goes on by its point reflection 2 x(T) - x(2 T - t), which fades into the first value within another
// length of the record (raised cosine). Gustafsson 1996, IEEE Trans. Signal Process. 44(4), on edges of records.
//
// What the samples themselves have folded, above half their rate, no filter can tell from what is below.
#pragma once

#include <complex>
#include <functional>

#include "harness/metrics/fourier.h"

namespace mb {

double low_pass(double f, double f_c);  // H; f >= 0, f_c > 0, both in the same unit

class PaddedSpectrum {
 public:
  // x: one signal a row, samples at 0, 1/rate, 2/rate, ... in columns (at least two), all finite; rate [1/s] > 0.
  PaddedSpectrum(const MatrixXd& x, double rate);

  // The gain of a linear filter at f [1/s] >= 0: real where it shifts nothing, 2 pi i f for the derivative.
  using Gain = std::function<std::complex<double>(double f)>;
  // sum_k g(f_k) X_k e^{2 pi i f_k t} of every signal at every time t [s], all within the record.
  MatrixXd at(const VectorXd& t, const Gain& gain) const;
  // Mean of its square over the padded record, signal by signal.
  VectorXd mean_square(const Gain& gain) const;

 private:
  std::complex<double> one_sided(Index k, const Gain& gain) const;  // gain, twice where k has a mirror image

  double end_;   // [s]
  VectorXd f_;   // [1/s] 0 ... rate/2
  MatrixXcd X_;  // signals x frequencies
};

}  // namespace mb
