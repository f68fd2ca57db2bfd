// The bodies that are measured: a free cylinder of quadratic elements, mu = rho = 1, radius 1/2, length 2, nu = 0.3.
#pragma once

#include <memory>

#include "cases/contract/model.h"

namespace mb {

inline constexpr double cylinder_shift = -1;  // [1/s^2] of the shift-inverted pencil

Scene cylinder_scene(int n_splits);  // 5 n_splits^2 x 2 n_splits cells: 2, 4, 8 make 2,403, 17,187, 129,987 unknowns
std::shared_ptr<const FullModel> cylinder(int n_splits);

}  // namespace mb
