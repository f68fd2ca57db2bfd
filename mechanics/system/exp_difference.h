// Divided differences of the exponential at complex nodes with real parts <= 0, however close or far apart:
//
//   exp[a] = e^a,   exp[a, ..., x, y] = (exp[a, ..., x] - exp[a, ..., y]) / (x - y),   exp[a, a] = e^a
//
// The recursion divides by the largest separation, nodes at most 1 apart take the Taylor series about their mean: no
// step loses more than a digit. McCurdy, Ng & Parlett 1984, Math. Comp. 43.
#pragma once

#include <complex>

namespace mb {

std::complex<double> exp_difference(std::complex<double> a, std::complex<double> b);
std::complex<double> exp_difference(std::complex<double> a, std::complex<double> b, std::complex<double> c);
std::complex<double> exp_difference(std::complex<double> a, std::complex<double> b, std::complex<double> c,
                                    std::complex<double> d);

}  // namespace mb
