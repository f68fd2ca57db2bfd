// How far the modes of a body in flight can ever move it: each mode's energy only falls,
//
//   |q| <= sqrt(2 E / lambda),   |q'| <= sqrt(2 E),   |q''| <= lambda |q| + c |q'| + |w|,   E = (q'^2 + lambda q^2)/2
//
// about the mode's rest under the weight w, times the largest |phi|, |grad phi| and |grad grad phi| of the mode on the
// body's box, from sums of its polynomial's coefficients (each monomial is at most 1 there).
#pragma once

#include "mechanics/geometry/polynomial_regression.h"
#include "modal/contact/floating_body.h"

namespace mb {

// Of every mode, r: bounds on the box |xi| <= 1 of  |phi| [1], |d phi/dX| [1/m] and |d2 phi/dX2| [1/m^2].
struct ShapeBounds {
  VectorXd value, gradient, bend;
};
ShapeBounds shape_bounds(const PolynomialBasis& geometry);

// Over [ta, tb], of modes with the state q, p at ta' <= ta: bounds of |q|, |q'| and |q''|, r each.
struct AmplitudeBounds {
  VectorXd q, p, a;
};
AmplitudeBounds amplitude_bounds(const FloatingBody& body, const VectorXd& q, const VectorXd& p, double duration);

}  // namespace mb
