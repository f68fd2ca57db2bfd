// Which modes of one mesh are those of another: not those of the same place in the order, where two cross between
// meshes, but those that move alike, at the quadrature of the exact shape,
//
//   MAC_ij = (a_i . b_j)^2 / (|a_i|^2 |b_j|^2),   a_i = sqrt(w) u_i,   b_j = sqrt(w) u_j
//
// (Allemang 2003, Sound & Vibration 37(8), the modal assurance criterion). Modes of a multiplet are any rotation of
// each other: a mode is paired with all that share it, each at least half as much as the best does.
#pragma once

#include <vector>

#include "cases/contract/model.h"

namespace mb {

// sqrt(w) u of modes Phi (n x k) at the points of `volume`, columns of unit norm: 3 p x k.
MatrixXd seen_at(const FullModel& full, const Quadrature& volume, const MatrixXd& Phi);

// Of every column of `own` those of `other`, ascending; none where no MAC is a twentieth: of a multiplet of nine, as a
// sphere has, the best is a ninth at least, less what the meshes differ by.
using ModePairs = std::vector<std::vector<Index>>;
ModePairs mode_pairs(const MatrixXd& own, const MatrixXd& other);

// Which of `pairs` has the frequency [rad/s] farthest from omega; -1: there is none.
Index farthest(double omega, const VectorXd& omega_of_other, const std::vector<Index>& pairs);

// How many modes more of the other mesh are to be looked through: those of the last ones may stand behind them there.
inline constexpr int more_of_other = 6;

}  // namespace mb
