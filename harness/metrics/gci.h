// Grid convergence from three answers f1 (fine), f2, f3 (coarse) on meshes whose spacings differ by the ratio r:
//
//   p = ln((f3 - f2) / (f2 - f1)) / ln r                observed order
//   f* = f1 + (f1 - f2) / (r^p - 1)                     Richardson's extrapolation to vanishing spacing
//   GCI_fine   = 1.25 |f2 - f1| / (|f1| (r^p - 1))      error band of f1, relative
//   GCI_coarse = 1.25 |f3 - f2| / (|f2| (r^p - 1))      of f2; r^p GCI_fine in the asymptotic range
//
// 1.25 is the factor of safety for three meshes; with two, whose order p is that of theory, it is 3:
//
//   GCI_fine   = 3 |f2 - f1| / (|f1| (r^p - 1))
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

// refinement [-] > 1: coarse over fine spacing; else std::invalid_argument. Nothing where the answers do not converge
// monotonically (equal, oscillating, drifting apart), are not finite, or f1 or f2 is 0: there is no such number then.
std::optional<GridConvergence> grid_convergence(double f1, double f2, double f3, double refinement);

// [-] GCI of f1 from two meshes of the order of theory, > 0 else std::invalid_argument, as for a ratio that is not
// above 1. Nothing where an answer is not finite or f1 is 0.
std::optional<double> gci_of_two(double f1, double f2, double refinement, double order);

}  // namespace mb
