// Step limits: the largest h with spectral radius of the one-step amplification at most 1,
//
//   y+ = A(omega h, zeta) y     for     q'' + 2 zeta omega q' + omega^2 q = 0
//
// Growth in a few steps would lie: explicit Euler at 1.001 of its limit grows by a factor 1.008 in 10^4 steps. With
// B = A - I both eigenvalues lie in the unit disc where (Jury 1964, Theory and Application of the z-Transform)
//
//   tr B + det B <= 0,   det B >= 0,   4 + 2 tr B + det B >= 0
//
// each with an allowance of 1e-12 of its terms for rounding. Unlike 1e-12 on the spectral radius itself that holds at
// small steps too, where undamped explicit Euler grows by omega^2 h^2/2 a step: its limit is 0, not 1.4e-6/omega.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mechanics/types.h"

namespace mb {

struct System;
using Matrix2d = Eigen::Matrix2d;

struct Scheme {
  std::string name;        // "explicit-euler", "symplectic-euler", "symplectic-euler, implicit damping", ...
  std::string integrator;  // of the catalogue where it steps so, or ""
  std::function<Matrix2d(double omega_h, double zeta)> increment;  // A - I of (q, h v); omega_h > 0, zeta >= 0
  std::function<double(double zeta)>
      formula;               // omega h at the limit by theory; infinity: none; NaN where none is known
  std::string formula_text;  // "2 (sqrt(1 + zeta^2) - zeta) / omega"
  std::string source;

  Matrix2d amplification(double omega_h, double zeta) const { return Matrix2d::Identity() + increment(omega_h, zeta); }
};
const std::vector<Scheme>& schemes();           // the visible list: every scheme and damping variant
const Scheme& scheme(const std::string& name);  // throws std::out_of_range naming it

// Whether the integrator named by the scheme damps the system as the scheme does: central differences treat damping
// implicitly but for what a lumped mass would couple (central_difference.h).
bool steps_as(const Scheme& scheme, const System& system);
// The scheme by which the integrator steps the system; nullptr where none is known.
const Scheme* scheme_of(const std::string& integrator, const System& system);

double spectral_radius(const Matrix2d& A);

// A of "central-difference, lagged damping" where of zeta the part zeta_by_mean >= 0 does not lag.
Matrix2d lagged_amplification(double omega_h, double zeta, double zeta_by_mean);

// omega h where stability first ends, by bisection to 1e-9 of it; 0: unstable at any step; infinity: stable at any, up
// to 1e6. What the allowance moves is more at ratios far above critical: 2e-12 zeta of it by central differences, 4e-12
// zeta by Newmark's schemes of gamma = 1/2; of those of gamma > 1/2 it is 6e-5 at a ratio of 100, and at 1000 no limit
// is found. zeta >= 0 and finite, else std::invalid_argument.
double stable_omega_h(const Scheme& scheme, double zeta);

}  // namespace mb
