// Mode shapes as polynomials: regression onto monomials (Pentland & Williams 1989, section 4, eq. 6)
//
//   a = argmin  sum_i w_i |phi(X_i) - sum_k a_k m_k(X_i)|^2,      a = (B^T W B)^-1 B^T W phi where B has full rank
//
// Formed like that, the condition number is squared. Here the monomials, scaled to the body's box, are made orthonormal
// in the weighted product degree by degree (Gram-Schmidt twice, within each degree the largest remainder first):
//
//   W^1/2 B = Q R,     a = R^-1 Q^T W^1/2 phi
//
// A monomial whose remainder is rounding is determined by those before it and left out (coefficient 0): z^2 on the
// surface of a sphere, all but x^i y^j on a plane. So what the points leave open is settled for the lowest degree, and
// within a degree for the first in order. Off the points the fit is then one of many: to use it inside a body, fit at
// points inside.
#pragma once

#include <vector>

#include "mechanics/geometry/polynomial_basis.h"

namespace mb {

struct RegressionTolerances {
  // [-] in [0, 1): root mean square of a monomial's remainder below which it counts as determined by the others. True
  // remainders are above 1e-3 up to degree 8 in a box or ball, rounding is below 1e-14: the default is well apart from
  // both, and a thin shell (remainders as large as its thickness by its radius) keeps its monomials.
  double rank = 1e-8;
  // [-] >= 0: of each mode coefficients are dropped, smallest first, as long as the sum of their magnitudes is at most
  // this times the mode's root mean square. As |m_k| <= 1 the mode then changes by less everywhere in the box. The
  // default is far below what meshes resolve and above what rounding leaves of coefficients that vanish by symmetry.
  double drop = 1e-10;
};

struct ModeFit {
  double residual;             // [-] weighted root mean square of what is left over the mode's own; after dropping
  double largest_residual;     // [-] largest |phi(X_i) - fit| over largest |phi(X_i)|; after dropping
  int degree;                  // highest of the coefficients kept, 0 for a mode that vanishes
  Index n_kept;                // coefficients that are kept, of 3 monomials
  VectorXd residual_by_degree; /* [-] degree + 1: the residual of the best fit of degree 0, 1, ...; before dropping */
};

struct Regression {
  PolynomialBasis basis;  // its degree is that of the highest coefficient kept in any mode
  Index n_monomials;      // offered
  Index rank;             // of these determined by the points and weights
  double condition;       // [-] >= 1: largest over smallest singular value of W^1/2 B of the monomials determined
  std::vector<ModeFit> modes;
};

// Points X [m] 3 x p with weights w p (area or volume, >= 0, of any scale), modes U 3p x r: x, y, z at point 0, ...
// Throws std::invalid_argument where sizes disagree, a number is not finite, a weight is negative, all weights vanish,
// a tolerance is out of range or a point has |xi| > 2. Points outside |xi| <= 1 weaken what `drop` promises.
Regression regress(const Monomials& monomials, const Matrix3Xd& X, const VectorXd& w, const MatrixXd& U,
                   const RegressionTolerances& tolerances = {});

}  // namespace mb
