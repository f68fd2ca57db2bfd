// Loads on a body in its floating frame (floating_body.h). Nodal forces g_a, a pattern each, act with amplitudes a(t,
// Q):
//
//   force  sum f_a a,   torque about c  sum (T_a + sum_i q_i dT_ai) a,   on the modes  P a,       in body axes
//   f_a = sum_n g_an,   T_a = sum_n X_n x g_an,   dT_ai = sum_n phi_in x g_an,   P_ia = phi_i . g_a
//
// A load that turns with the body is one pattern, a = s(t). One that keeps the axes of the start is nine, each the
// nodal forces' component l laid along axis k, a_kl = Q_lk s(t): sum over k, l gives Q^T g.
#pragma once

#include <functional>
#include <vector>

#include "mechanics/system/system.h"

namespace mb {

struct FrameForce {
  Vector3d force, torque;  // [N], [N m] body axes; about c
  VectorXd modal;          // [N kg^-1/2] r
};

struct FrameLoads {
  std::vector<std::function<double(double)>> s;  // one a load
  std::vector<bool> follows;                     // likewise: one pattern, or nine
  std::vector<double> jumps;                     // [s] ascending: where a history may jump, or bend
  double longest_step;                           // [s] that sees what histories do between
  Matrix3Xd f, T;                                // [N], [N m] 3 x m
  MatrixXd dT;                                   // [N kg^-1/2] 3 m x r
  MatrixXd P;                                    // [N kg^-1/2] r x m

  Index n_patterns() const { return f.cols(); }
  // m, at t [s] as seen from `since` <= t: a jump between, or at t, is yet to come. One thread at a time.
  VectorXd amplitudes(double t, double since, const Eigen::Quaterniond& Q) const;
  FrameForce at(double t, double since, const Eigen::Quaterniond& Q, const VectorXd& q) const;
  double next_jump(double t) const;  // [s] the first after t; infinity: none
};

// Nodal forces of the patterns of a body without supports in the scene's order of loads: n x m.
MatrixXd load_patterns(const System& system);

// X [m] n: places of the unknowns about the centroid; Phi n x r; duration [s] of the scene.
FrameLoads frame_loads(const System& system, const VectorXd& X, const MatrixXd& Phi, double duration);

}  // namespace mb
