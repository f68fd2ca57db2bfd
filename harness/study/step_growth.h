// What free vibration grows by, in theory, over a run of equal steps without contact:
//
//   growth = rho^n,   n = duration / h,   rho the spectral radius of one step (stability.h, one_step.h)
//
// rho over all modes of a reduced body, those that damping couples together, and of one step of a whole mesh
// (modal/bases/mesh_radius.h), which of explicit Euler is an estimate. Of finite deformation it is that about rest, in
// contact that without: what grows there may stay bounded where what swings softens, and is no motion of its own all
// the same. Above 1 the step is past its limit; how far the run shows it depends on n.
#pragma once

#include "cases/contract/linear.h"

namespace mb {

// [-] Largest over the bodies; NaN where nothing is known: modes in frames that turn or touch, schemes without a
// matrix. h and duration [s] > 0.
double predicted_growth(const Reduction& reduction, const std::string& integrator, double h, double duration);

struct Grown {
  double by_theory;      // [-] as above
  bool about_rest;       // whether that is the theory of another motion: of finite deformation
  bool unknown = false;  // whether theory should tell of these steps, and does not
};
// Of conditionally stable integrators, of others nothing is known; reduction: or nullptr.
Grown growth_of(const Reduction* reduction, const Integrator& integrator, double h, double duration);

}  // namespace mb
