// What every factorisation here asks of its matrix.
#pragma once

#include "mechanics/types.h"

namespace mb {

// Throws std::invalid_argument for a matrix that is empty, not square, not compressed or not finite.
void require_factorisable(const SparseMatrix& A);

}  // namespace mb
