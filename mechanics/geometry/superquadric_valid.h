// What counts as a superquadric: semi-axes in [1e-100, 1e100] m, exponents in [0.1, 2].
#pragma once

#include "mechanics/geometry/shape.h"

namespace mb {

void require_valid(const Superquadric& body);  // else std::invalid_argument

}  // namespace mb
