// One step of modes in contact, linearised: the layer pressed at one point as hard as at the height of the impact,
//
//   q'' + c q' + Lambda q + kappa g g^T q = 0,   g = Phi^T U(X)^T n,   kappa = k_n pi a^2
//
// by each of the schemes of modal/contact/contact_step.h. Where the spectral radius of the step passes 1, contact feeds
// energy: explicit kicks at about 2/omega of the stiffened modes, average acceleration nowhere.
#pragma once

#include <string>

#include "mechanics/types.h"

namespace mb {

struct PressedModes {
  VectorXd lambda, c;  // [1/s^2], [1/s] n, rigid modes with 0
  VectorXd g;          // [kg^-1/2] n
  double kappa;        // [N/m] > 0
};

// scheme: "exact", "symplectic-euler" or "newmark"; else std::invalid_argument. h [s] > 0.
double pressed_radius(const PressedModes& pressed, const std::string& scheme, double h);

// The least step [s] at which that is above 1 by more than 1e-6; infinity: none up to `most` [s].
double pressed_limit(const PressedModes& pressed, const std::string& scheme, double most);

}  // namespace mb
