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
// exactly: growth over n steps is compared with rho^n without waiting for a peak. Where lambda is real the run starts
// in its eigenvector, lest a mode damped beyond 1 hide its growth below rounding of a displacement that hardly moves.
#pragma once

#include <limits>
#include <string>

#include "cases/contract/method.h"
#include "mechanics/system/stability.h"
#include "modal/bases/highest_mode.h"

namespace mb {

struct StepLimit {
  double dt;       // [s] 0: unstable at any step; infinity: stable at any
  Index deciding;  // the mode that sets it
};
// omega [rad/s] > 0, zeta [-] >= 0, of all modes kept; at least one.
StepLimit measured_limit(const Scheme& scheme, const VectorXd& omega, const VectorXd& zeta);
double formula_limit(const Scheme& scheme, const VectorXd& omega, const VectorXd& zeta);  // [s]; NaN: no formula
// [-] Of a measured limit, relative, by any of explicit_schemes(): bisection, and what the allowance for rounding
// (stability.h) moves where the terms that cancel are zeta times their difference.
double bar_of_limit(double zeta);

// Explicit schemes of schemes() and their damping variants, as this analysis lists them.
std::vector<Scheme> explicit_schemes();

// The system without its loads, let go from rest in phi.
System let_go(const System& system, const VectorXd& phi);

struct GrowthRun {
  double dt;                // [s]
  long n_steps;             // over which growth is taken
  double theory, observed;  // [-] rho^n and what the run shows; NaN where it was not finite
  double phase = std::numeric_limits<double>::infinity();  // [rad] n omega dt
  double other_modes = 0;                                  // [-] what they may add to the logarithm of growth
};
// [-] Of the logarithm observed from that by theory, over that by theory or 1e-6, whichever is larger: a run that
// neither grows nor decays has no logarithm to divide by. And its bar: rounding of n steps, and other modes, which
// bar_of_growth is of the logarithm itself.
double difference_of_logarithms(const GrowthRun& run);
double bar_of_difference(const GrowthRun& run);
double bar_of_growth(const GrowthRun& run);
// "confirmed" where that difference is at most 1 %: of 1e-6 it is 1e-8. "too short to tell" where theory says that the
// logarithm stays within that 1e-8 and the mode turned by less than a radian meanwhile. Both whatever the bar.
std::string growth_verdict(const GrowthRun& run);
// As many steps as growth by a factor 3 takes, in [20, most_steps]. system: its loads and initial state are not used.
GrowthRun growth_run(const System& system, const SteppedMode& mode, const Scheme& scheme, const Integrator& integrator,
                     double dt, long most_steps);
// Of a mesh whose step grows by rho, pushed off in phi, which is no eigenvector of one step: of what a step moves, over
// as many steps again as it takes until that mode is all there is, at most 200. An overdamped mode let go would creep.
GrowthRun growth_run(const System& system, const SteppedMode& mode, const Integrator& integrator, double dt,
                     double rho);

}  // namespace mb
