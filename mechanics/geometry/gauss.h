// Gauss-Legendre rule on [0, 1]:  integral f ~ sum_i w_i f(x_i), exact for polynomials of degree 2n - 1.
#pragma once

#include "mechanics/types.h"

namespace mb {

struct Rule {
  VectorXd x, w;
};                           // [-] nodes ascending in (0, 1), weights sum to 1
Rule gauss_legendre(int n);  // n >= 1, else std::invalid_argument

}  // namespace mb
