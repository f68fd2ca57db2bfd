// Comparing two signals m (measured against) and c (compared) over time, theta_ab = int a b dt by the trapezoidal rule:
//
//   M = sqrt(theta_cc / theta_mm) - 1                    magnitude; negative: too small
//   P = arccos(theta_mc / sqrt(theta_mm theta_cc)) / pi  phase, in [0, 1]; phi/pi for whole periods shifted by phi
//   C = sqrt(M^2 + P^2)                                  both
//
// Sprague & Geers 2004, Commun. Numer. Meth. Engng 20, pp. 467-474; Schwer 2007, Eng. with Computers 23.
#pragma once

#include "mechanics/types.h"

namespace mb {

// w with sum_i w_i f(t_i) the trapezoidal rule on ascending times; {1} for a single time.
VectorXd trapezoid_weights(const VectorXd& t);

// All three are NaN where m vanishes; P and C also where c does: nothing has no phase.
struct SpragueGeers {
  double magnitude, phase, combined;
};
SpragueGeers sprague_geers(const VectorXd& weights, const VectorXd& c, const VectorXd& m);

// sqrt(theta_(c-m)(c-m) / theta_mm); NaN where m vanishes.
double relative_l2(const VectorXd& weights, const VectorXd& c, const VectorXd& m);

}  // namespace mb
