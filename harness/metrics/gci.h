// Grid convergence from three answers f1 (fine), f2, f3 (coarse) on meshes whose spacings differ by the ratio r:
//
//   p = ln((f3 - f2) / (f2 - f1)) / ln r                observed order
//   f* = f1 + (f1 - f2) / (r^p - 1)                     Richardson's extrapolation to vanishing spacing
//   GCI_fine   = F |f2 - f1| / (|f1| (r^q - 1))         error band of f1, relative
//   GCI_coarse = F |f3 - f2| / (|f2| (r^q - 1))         of f2; r^p GCI_fine in the asymptotic range
//
// F = 1.25, q = p where p is within a tenth of the order of theory; elsewhere the meshes are not in the asymptotic
// range, F = 3 and q = p, or the order of theory where p is more: differences that happen to be small promise nothing
// (Oberkampf & Roy 2010, Verification and Validation in Scientific Computing, sect. 8.6.3, but for q = p near theory,
// which is Roache's). With two meshes F = 3 and q the order of theory.
//
// The analysis of natural frequencies bounds its finest mesh so, without the published ones, and drifts of energy their
// windows. Roache 1998, Verification
// and Validation in Computational Science and Engineering, ch. 5; NASA Glenn, Examining Spatial (Grid) Convergence, for
// a worked example.
#pragma once

#include <optional>

namespace mb {

struct GridConvergence {
  double order;         // [-] p > 0
  double extrapolated;  // f*, in the unit of f
  double fine, coarse;  // [-] GCI of f1 and of f2, fractions (0.01 is one per cent)
  double asymptotic;    // [-] GCI_coarse / (r^p GCI_fine): near 1 in the asymptotic range
};

// refinement [-] > 1: coarse over fine spacing, theory [-] > 0: the order; else std::invalid_argument. Nothing where
// the answers do not converge monotonically (equal, oscillating, drifting apart), are not finite, or f1 or f2 is 0:
// there is no such number then.
std::optional<GridConvergence> grid_convergence(double f1, double f2, double f3, double refinement, double theory);

// [-] GCI of f1 from two meshes of the order of theory, > 0 else std::invalid_argument, as for a ratio that is not
// above 1. Nothing where an answer is not finite or f1 is 0.
std::optional<double> gci_of_two(double f1, double f2, double refinement, double order);

}  // namespace mb
