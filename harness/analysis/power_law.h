// The exponent of a power law between measured values, by least squares in logarithms:
//
//   log y = log a + p log x,   standard error of p = sqrt( sum residual^2 / (n - 2) / sum (log x - mean)^2 )
#pragma once

#include "mechanics/types.h"

namespace mb {

struct PowerLaw {
  double exponent;        // [-] NaN where x are all the same, and where the standard error is
  double standard_error;  // [-] NaN where fewer than three points are: two say nothing of how well a line fits
  Index n_points;         // those with 0 < x, y < infinity; others are left out
};
PowerLaw power_law(const VectorXd& x, const VectorXd& y);
// Of y -> 0 with x: the law of as many of the least x, from four on, as give the smallest standard error. What is far
// from the limit bends away, and what scatters is known best by all points. Of three, of these.
PowerLaw power_law_of_least(const VectorXd& x, const VectorXd& y);

// Whether a measured exponent is the one claimed: within 0.05 (over two decades a quarter of the value) or two standard
// errors. False where it is NaN, and where it is known no better than to a quarter.
bool agrees(const PowerLaw& law, double claimed);

}  // namespace mb
