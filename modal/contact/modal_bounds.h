// How far the modes of a body in flight can ever move it: each mode's energy only falls,
//
//   |q| <= sqrt(2 E / lambda),   |q'| <= sqrt(2 E),   |q''| <= lambda |q| + c |q'| + |w|,   E = (q'^2 + lambda q^2)/2
//
// about the mode's rest under the weight w, times the largest |phi|, |grad phi| and |grad grad phi| of the mode over
// the solid body. Of a polynomial of degree d these follow from a grid in coordinates fitted to the shape
// (superquadrics: to an ellipsoid about them), N a direction,
//
//   max |phi| <= max over the grid |phi| / prod cos(pi d / 2N)      at Chebyshev's nodes, cos(pi d / N) at equal angles
//   |grad phi| <= d^2/w max |phi|,    |grad grad phi| <= d^2 (d-1)^2 / w^2 max |phi|,    w: half the least width
//
// (Ehlich & Zeller 1964, Math. Z. 86; Sarantopoulos 1991, Math. Proc. Camb. Phil. Soc. 110, for symmetric convex
// bodies), or from sums of its coefficients, each monomial being at most 1 on the body's box: the lesser of both.
#pragma once

#include "mechanics/geometry/polynomial_regression.h"
#include "mechanics/geometry/shape.h"
#include "modal/frame/floating_body.h"

namespace mb {

// Of every mode, r: bounds on the body of  |phi| [1], |d phi/dX| [1/m] and |d2 phi/dX2| [1/m^2].
struct ShapeBounds {
  VectorXd value, gradient, bend;
};
ShapeBounds shape_bounds(const Shape& shape, const PolynomialBasis& geometry);

// Over [ta, tb], of modes with the state q, p at ta' <= ta: bounds of |q|, |q'| and |q''|, r each.
struct AmplitudeBounds {
  VectorXd q, p, a;
};
AmplitudeBounds amplitude_bounds(const FloatingBody& body, const VectorXd& q, const VectorXd& p, double duration);

}  // namespace mb
