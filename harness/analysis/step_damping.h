// Damping that a scheme of fixed step really gives a mode. With lambda the eigenvalue of largest modulus of the
// amplification (stability.h), compared with that of the motion itself, exp((-zeta +- i sqrt(1 - zeta^2)) omega h):
//
//   zeta_num = -ln|lambda| / Omega,   Omega = |ln lambda| = sqrt(ln^2|lambda| + arg^2 lambda)
//
// Omega is the numerical omega h: a scheme without error has zeta_num = zeta, explicit Euler without damping
// -ln(1 + omega^2 h^2)/2 over sqrt(ln^2(1 + omega^2 h^2)/4 + atan^2(omega h)). Of an answer that creeps, both lambda
// being positive, the same continued beyond critical damping, where Omega^2 = ln lambda_1 ln lambda_2:
//
//   zeta_num = -(ln lambda_1 + ln lambda_2) / (2 sqrt(ln lambda_1 ln lambda_2))
//
// NaN where neither holds: one grows and one decays, or signs differ and the negative one does not outlast. Hughes
// 2000, The Finite Element Method, sect. 9.1.3, for algorithmic damping.
#pragma once

#include "harness/analysis/step_limit.h"

namespace mb {

double step_damping(const Scheme& scheme, double omega_h, double zeta);  // omega_h > 0, zeta >= 0

// The same from a run of the integrator, let go from rest in the mode: lambda^m of every m-th displacement, m omega h
// about 1, or 1/(2 zeta) beyond critical damping, by least squares of y_{k+2} = T y_{k+1} - D y_k: nothing is assumed
// but that a mode has two states. NaN where that is NaN, where one state is gone below 1e-2 between samples, or where
// the run is not finite.
double run_damping(const System& system, const SteppedMode& mode, const Integrator& integrator, double dt);

}  // namespace mb
