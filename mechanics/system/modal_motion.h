// Motion of uncoupled modes under loads that are chains of lines and waves, in closed form:
//
//   q_i'' + c_i q_i' + lambda_i q_i = sum_l f_il s_l(t)
//
// and its exact means over intervals of time. What exact.h is made of.
#pragma once

#include <vector>

#include "mechanics/system/oscillator.h"
#include "mechanics/system/system.h"

namespace mb {

// Every load on [start, end) [s], between breakpoints of any of them: one segment a load, all from the same start.
struct Piece {
  double start, end;
  std::vector<Segment> loads;
};
// chains: one a load, each tiling [0, duration].
std::vector<Piece> merged(const std::vector<Segments>& chains, double duration);

struct ModalMotion {
  std::vector<Roots> modes;
  MatrixXd f;                 // [N kg^-1/2] n_modes x n_loads
  VectorXd q0, v0;            // at t = 0
  std::vector<Piece> pieces;  // tile [0, duration], at least one

  Index n_modes() const { return static_cast<Index>(modes.size()); }
  Index n_loads() const { return f.cols(); }
};

struct ModalStates {
  MatrixXd q, v;  // n_modes x number of times
  Work work;      // steps: closed forms evaluated; load_evaluations: segments projected
};

// times [s] ascending in [0, duration].
ModalStates states(const ModalMotion& motion, const VectorXd& times);

// Means of q and v over [t - width/2, t + width/2], with q = q0 and v = 0 before t = 0. times [s] ascending, >= 0;
// width [s] > 0; no window ends beyond the duration.
ModalStates means(const ModalMotion& motion, const VectorXd& times, double width);

}  // namespace mb
