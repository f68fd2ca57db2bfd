// Full order as a contender like any other: every degree of freedom of the mesh, stepped by the integrator given.
#pragma once

#include <memory>

#include "cases/contract/method.h"

namespace mb {

std::unique_ptr<Method> full_order();

}  // namespace mb
