#include "mechanics/algebra/factorisable.h"

#include <cmath>
#include <stdexcept>

namespace mb {

void require_factorisable(const SparseMatrix& A) {
  if (A.rows() == 0 || A.rows() != A.cols())
    throw std::invalid_argument("a factorisation needs a square matrix of at least one row");
  if (!A.isCompressed()) throw std::invalid_argument("a factorisation needs a compressed matrix");
  for (Index k = 0; k < A.nonZeros(); ++k)
    if (!std::isfinite(A.valuePtr()[k])) throw std::invalid_argument("a matrix to factorise has an entry not finite");
}

}  // namespace mb
