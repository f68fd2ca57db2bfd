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
// The limit h is the least at which that at mu = 1 is singular, 4 M + 2 s h C - h^2 K with s = -1, 0 or 1 for damping
// by the old, the mean or the new rate, found likewise from above: h(phi) = 4/(sqrt(s^2 c^2 + 4 k) - s c).
//
// Explicit Euler has complex ones above 1: that of the highest mode, of single modes that are damped by themselves and
// of the motion that V damps most, where joined bodies are damped unlike (joined.h), each as if no other moved. An
// estimate, exact where damping is of mass and stiffness and single modes are modes.
#pragma once

#include <optional>

#include "mechanics/system/stability.h"
#include "modal/bases/highest_mode.h"

namespace mb {

constexpr int rounds_of_radius = 50;  // of mode and number by turns: some three are needed

// [-] Of a step h [s] > 0, by the mass with which the scheme steps. integrator: "symplectic-euler",
// "central-difference" (central_difference.h; of finite deformation, about rest) or "explicit-euler"; of others NaN,
// and where rho still rises after most_rounds.
double mesh_radius(const System& system, const std::string& integrator, double h, int most_rounds = rounds_of_radius);

struct MeshLimit {
  double dt;         // [s]
  SteppedMode mode;  // that which grows first beyond it
};
// Of schemes that kick and drift, by the mass of the system itself: "symplectic-euler", "symplectic-euler, implicit
// damping", "central-difference", "central-difference, lagged damping"; of others nothing, and where dt still falls
// after most_rounds.
std::optional<MeshLimit> mesh_limit(const System& system, const Scheme& scheme, int most_rounds = rounds_of_radius);

}  // namespace mb
