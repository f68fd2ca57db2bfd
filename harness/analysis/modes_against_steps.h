// What modes and steps make of a body that an analysis has changed, under the loads of its scene, on its own mesh:
//
//   modes against steps = |u_r - u| / |u| in the M norm over the sample times
//
// u_r: modes with static correction in closed form; u: all unknowns by adaptive steps. Energies: E(t)/E(0) at most, of
// free vibration of the modes, all alike (stability_grid.h), at steps over the limit of central differences.
#pragma once

#include "cases/contract/model.h"
#include "harness/analysis/analysis.h"

namespace mb {

struct SolvedBody {
  Model model;
  Modes modes;
  MatrixXd at_rest;  // [m] n x loads
  const System& system() const { return model.bodies.front().full->system(); }
  double first() const { return modes.omega(modes.n_rigid); }  // [rad/s]
};
// The scene's first body with n_modes elastic modes. Throws as model_of_own_mesh and lowest_modes.
SolvedBody solved_body(const Scene& scene, int n_modes);

struct BarredFrequency {
  double hertz, bar;  // of the first elastic mode; of its mesh (another_mesh), and rounding
};
BarredFrequency first_frequency(const SolvedBody& body, const Scene& scene);

struct BarredEnergy {
  double value, bar;  // [-] bar: of rounding (bar_of_energy); 0 where the energy is not finite
};

struct ModesAgainstSteps {
  double off, bar;                           // [-] against steps at rtol 1e-6; how far these at 1e-5 are from them
  BarredEnergy newmark_far_past;             // at 1000 times the limit of central differences
  BarredEnergy central_below, central_past;  // of these at 0.99 and 1.01 of it
};
ModesAgainstSteps modes_against_steps(const AnalysisContext& context, const SolvedBody& body, const Scene& scene);

}  // namespace mb
