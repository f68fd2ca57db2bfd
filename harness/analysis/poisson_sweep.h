// A body's static answer and its first frequency over Poisson's ratio, by elements of every degree on meshes of about
// as many unknowns:
//
//   static error = |u_p - u| / |u| in the M norm,   frequency error = f_p / f - 1,   u, f: degree 4 on the finer mesh
#pragma once

#include <map>
#include <vector>

#include "cases/scene/scene.h"

namespace mb {

struct SweptAnswer {
  Resolution mesh;
  Index n;       // unknowns
  VectorXd u;    // [m] at the evaluation points of the volume, all loads at their full size
  double hertz;  // [1/s] first elastic mode
};

struct PoissonSweep {
  std::vector<double> ratios;
  VectorXd weights;                                 // [m^3] of the evaluation points
  std::map<int, std::vector<SweptAnswer>> answers;  // by degree, one a ratio
  // One a ratio: on half as many cells again as the finer mesh has, and on its own.
  std::vector<SweptAnswer> truths, beside;
};
// ratios in (-1, 1/2). Throws std::invalid_argument for other bodies than boxes of one isotropic material, and where no
// load deforms the body.
PoissonSweep poisson_sweep(const Scene& scene, const std::vector<double>& ratios);

struct LockingError {
  double of_displacement, of_frequency;  // [-]
};
LockingError locking_error(const SweptAnswer& answer, const SweptAnswer& truth, const VectorXd& weights);

}  // namespace mb
