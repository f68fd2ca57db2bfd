// Steady state of a system under harmonic loads:
//
//   F s e^{i omega t}  ->  u e^{i omega t},   (K - omega^2 M + i omega C) u = F s
//
// A free body is answered for omega > 0. Craig 1981, Structural Dynamics, sect. 4.2.
#pragma once

#include <complex>
#include <vector>

#include "mechanics/algebra/complex_lu.h"
#include "mechanics/system/system.h"

namespace mb {

// u [m] for unit factors s_l (column l of F), at every omega [rad/s] > 0, for one load. n x number of frequencies.
// Diagonal systems (reduced in eigenmodes) are solved entry by entry. Damping of low rank enters by projection (rigid
// modes) or as a border of the sparse matrix (ratios of modes, with R^T W = 0), never as dense blocks. Throws
// std::runtime_error at an undamped resonance, std::invalid_argument for a load or a frequency out of range.
Eigen::MatrixXcd frequency_response(const System& system, Index load, const VectorXd& omega);

}  // namespace mb
