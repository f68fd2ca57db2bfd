// The largest stable step of an explicit scheme for a system known by its modes: stability.h mode by mode,
//
//   dt = min_i x(zeta_i) / omega_i,   x = omega h at the limit
//
// over all modes kept: with explicit Euler it is not always the highest that decides. And what bears it out, a run of
// the integrator that starts in the deciding mode. Displacements of a run obey y_{k+2} = tr A y_{k+1} - det A y_k, so
// that with lambda the eigenvalue of A of largest modulus and mu the other one
//
//   |y_{k+1} - mu y_k| = |lambda|^k |y_1 - mu y_0|
//
// exactly: growth over n steps is compared with rho^n without waiting for a peak.
#pragma once

#include "cases/contract/method.h"
#include "mechanics/system/stability.h"

namespace mb {

struct StepLimit {
  double dt;       // [s] 0: unstable at any step; infinity: stable at any
  Index deciding;  // the mode that sets it
};
// omega [rad/s] > 0, zeta [-] >= 0, of all modes kept; at least one.
StepLimit measured_limit(const Scheme& scheme, const VectorXd& omega, const VectorXd& zeta);
double formula_limit(const Scheme& scheme, const VectorXd& omega, const VectorXd& zeta);  // [s]; NaN: no formula

// Explicit schemes of schemes() and their damping variants, as this analysis lists them.
std::vector<Scheme> explicit_schemes();
// Whether the integrator named by the scheme damps the system as the scheme does: central differences treat damping
// implicitly but for what a lumped mass would couple (central_difference.h).
bool steps_as(const Scheme& scheme, const System& system);

// The system without its loads, let go from rest in phi.
System let_go(const System& system, const VectorXd& phi);

// A mode of the mass with which the integrator steps, phi^T M phi = 1.
struct SteppedMode {
  double omega, zeta;  // [rad/s], [-]
  VectorXd phi, M_phi;
};
struct GrowthRun {
  double dt;                // [s]
  long n_steps;             // over which growth is taken
  double theory, observed;  // [-] rho^n and what the run shows; NaN where it was not finite
};
// "confirmed" where ln observed = ln theory within 1 %: a run that neither grows nor decays confirms no growth. Within
// 1e-6 where theory says that the size stays.
std::string growth_verdict(const GrowthRun& run);
// As many steps as growth by a factor 3 takes, in [20, most_steps]. system: its loads and initial state are not used.
GrowthRun growth_run(const System& system, const SteppedMode& mode, const Scheme& scheme, const Integrator& integrator,
                     double dt, long most_steps);

// The mode of highest frequency by Lanczos on M^-1 K; zeta by C of the system.
SteppedMode highest_mode(const System& system);

// The system with its lumped mass as its only one, R orthonormal in it, as explicit integrators see it.
System with_lumped_mass(const System& system);
System with_consistent_mass(const System& system);  // and without the lumped one

}  // namespace mb
