// An error as the sum of its causes, each the difference of two answers that differ in one respect:
//
//   e = y_0 - y_n = a_1 + ... + a_n,   a_i = y_{i-1} - y_i
//   |e|^2 = sum_i |a_i|^2 + sum_{i<j} 2 <a_i, a_j>
//
// Parts are vectors: their norms do not add up where they point the same way, or against each other.
#pragma once

#include <functional>
#include <vector>

#include "harness/metrics/metric.h"

namespace mb {

struct Telescope {
  VectorXd parts;  // |a_i| / |y_n|
  MatrixXd cross;  // n x n; 2 <a_i, a_j> / |y_n|^2 above the diagonal, else 0
  double total;    // |e| / |y_n|
};
// chain: y_0 ... y_n, at least two of one size. NaN where the last one vanishes or an answer is not finite.
using Chain = std::vector<std::reference_wrapper<const MatrixXd>>;
Telescope telescope(const Chain& chain);

// Answers in the norms of the metrics (metric.h) as matrices whose Frobenius products are those norms' products over
// space and time: deformation in the M norm, strain in the K norm. 0 columns where strains were not recorded.
MatrixXd in_mass_norm(const Trajectory& answer, const MetricContext& context);
MatrixXd in_energy_norm(const Trajectory& answer, const MetricContext& context);

}  // namespace mb
