// Closed form of one mode,
//
//   q'' + c q' + k q = f s(t),   s(t) = c0 + c1 t + a cos(Omega t) + b sin(Omega t)
//
// in every regime: under-, critically, over-damped, k = 0, resonance. Written with divided differences of the
// exponential at the roots z1, z2 of z^2 + c t z + k t^2, so that nothing cancels as roots meet or vanish:
//
//   S = t exp[z1, z2],   P = t^2 phi1[z1, z2],   R = t^3 phi2[z1, z2],   X = t^2 exp[z1, z2, i Omega t]
//
// with phi1(z) = (e^z - 1)/z, phi2(z) = (phi1(z) - 1)/z. Integrals over time add another node 0: int R = T = t^4
// phi3[z1, z2] and int X = t^3 exp[z1, z2, i Omega t, 0]. Pentland & Williams 1989, eqs. 8-11, cover constant loads
// away from the critical case; divided differences: exp_difference.h.
#pragma once

namespace mb {

struct Oscillator {
  double k;  // [1/s^2] omega^2 >= 0
  double c;  // [1/s] 2 zeta omega >= 0
};

// Values at time t [s] >= 0 of the solutions of q'' + c q' + k q = f.
struct Response {
  double C, C_dot;  // free, q(0) = 1, q'(0) = 0
  double S, S_dot;  // free, q(0) = 0, q'(0) = 1 (impulse response)
  double P;         // from rest, f = 1 (its derivative is S)
  double R;         // from rest, f = t (its derivative is P)
};

// From rest, f = cos(Omega t) + i sin(Omega t): real and imaginary part of q and q'.
struct HarmonicResponse {
  double q_cos, q_sin, v_cos, v_sin;
};

// An oscillator's roots, found once for many evaluations: -h +- i mu when under-damped, else -slow and -fast.
struct Roots {
  // discriminant [1/s^2] h^2 - k. Throws std::invalid_argument where k or c is out of range.
  Roots(const Oscillator& oscillator, double omega, double discriminant);

  double k, omega;    // [1/s^2], [1/s] omega = sqrt(k)
  double h, mu;       // [1/s] h = c/2 and mu = sqrt|h^2 - k|
  double slow, fast;  // [1/s] both h when under-damped; slow * fast = k when over-damped
  bool underdamped;
};
Roots roots(const Oscillator& oscillator);
Response response(const Roots& roots, double t);
// free: response(roots, t), which the caller has at hand.
HarmonicResponse harmonic_response(const Roots& roots, const Response& free, double Omega, double t);

// Integrals over [0, t] of all of them, for exact means. None is a difference of what nearly cancels.
Response integral(const Roots& roots, const Response& at_t, double t);
HarmonicResponse integral(const Roots& roots, const Response& free, const HarmonicResponse& at_t, double Omega,
                          double t);

}  // namespace mb
