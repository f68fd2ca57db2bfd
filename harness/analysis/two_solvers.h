// Modes of one body by two solvers, multiplet by multiplet, since within one any basis will do.
#pragma once

#include <vector>

#include "cases/contract/modes.h"
#include "modal/bases/subspaces.h"

namespace mb {

struct TwiceFound {
  Cluster multiplet;
  double omega;       // [rad/s] the lowest by the second solver
  double gap;         // [-] of its eigenvalues from all others, by the second solver
  double difference;  // [-] largest of the frequencies, relative
  double distance;    // [-] of the subspaces (modal/bases/subspaces.h)
};

// modes: elastic ones in multiplets, as they are kept; lambda and Phi: all modes by the other solver, ascending, the
// same number of them rigid, M-orthonormal. Throws std::invalid_argument for sizes that do not fit and modes that are
// not finite.
std::vector<TwiceFound> twice_found(const SparseMatrix& M, const Modes& modes, const VectorXd& lambda,
                                    const MatrixXd& Phi);

}  // namespace mb
