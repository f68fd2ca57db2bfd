// The spectral radius rho of one step of an explicit scheme on a whole mesh, whatever damps it:
//
//   w+ = w + h M^-1 (-K u - C w),  u+ = u + h w+,    of C = C_l + C_i the part C_i by (w + w+)/2
//
// An eigenvalue of modulus above 1 is real and negative, -mu, and its mode phi has
//
//   ((1 + mu)^2 M - h (1 + mu) C_l + h/2 (mu^2 - 1) C_i - mu h^2 K) phi = 0
//
// Over (1 + mu)^2 that matrix grows with mu in every direction: rho = 1 where it is positive at mu = 1, which is
// 4 M - 2 h C_l - h^2 K, else the largest mu at which it is singular. phi is found by Lanczos at the last mu, mu by the
// quadratic in phi, which rises to its limit with the square of the distance.
//
// Explicit Euler has complex ones above 1: that of the highest mode, and of single modes that are damped by themselves,
// each as if no other moved. An estimate, exact where damping is of mass and stiffness and single modes are modes.
#pragma once

#include "mechanics/system/stability.h"

namespace mb {

// [-] Of a step h [s] > 0, by the mass with which the scheme steps. integrator: "symplectic-euler",
// "central-difference" (central_difference.h; of finite deformation, about rest) or "explicit-euler"; of others NaN.
double mesh_radius(const System& system, const std::string& integrator, double h);

}  // namespace mb
