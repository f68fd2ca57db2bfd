// Rotation and modes of a free body with coupling (spin.h) or loads (frame_loads.h) away from all obstacles: what
// couples them has no closed form.
//
//   y = (q, pi, Q),    q' = pi + g,   pi' = -lambda q - c q' + f,   Q' = Q Omega^,   g, f: what spin and loads add
//                      with loads y = (q, pi, Q, c, v, L):  c' = v,  m v' = Q force + m g,  L' = Q torque
//
// One step h is the classical Runge-Kutta method of order 4 in the variables that the exact flow of the free modes
// leaves constant, g and f there lines over the step (Lawson 1967, SIAM J. Numer. Anal. 4, 372-380): free vibration and
// steady stretching are exact whatever h, modes far faster than the spin follow it in balance, and without spin nothing
// is left to approximate.
//
// CoupledFlight halves and doubles h so that each step, against two of half the length, is off by at most a tolerance:
//
//   |error|^2 = (|d pi|^2 + |Lambda^1/2 d q|^2) / 2E + |d Q|^2,      E [J] of rotation and deformation
#pragma once

#include <map>
#include <vector>

#include "modal/frame/spin.h"

namespace mb {

class CoupledFlow {
 public:
  CoupledFlow(const FloatingBody& body, double h);  // h [s] >= 0; the body must outlive this
  // Q, q and p, with loads c, v and L, too, from t [s] on; the others stay as they are.
  BodyState advance(BodyState state, double t = 0) const;

 private:
  struct Slope {
    VectorXd q, p;  // of y; of what drives it g and f - c g
    Eigen::Vector4d Q;
    Vector3d c, v, L;  // 0 without loads
  };
  // g and f over the step as lines: values at t [s] and rates.
  struct Lines {
    double t;
    VectorXd g, f, g_rate, f_rate;
    Lines later(double tau) const { return {t + tau, g + tau * g_rate, f + tau * f_rate, g_rate, f_rate}; }
  };
  Slope drive(const BodyState& y, double t, double start) const;  // start [s] of the step: jumps of loads lie before it
  Lines lines(const BodyState& y, double t, const Slope& at_start, const Slope& frame) const;
  Slope slope(const BodyState& y, double t, const Lines& lines) const;
  BodyState flow(const BodyState& y, const Lines& lines) const;  // over h/2
  Slope flow(const Slope& x) const;                              // of free modes over h/2
  static Slope weighted(const Slope& k1, const Slope& k2, const Slope& k3, const Slope& k4);
  static BodyState add(BodyState y, const Slope& x, double part);  // y + part x

  const FloatingBody& body_;
  double h_;
  VectorXd damping_, C_, S_, C_dot_, S_dot_, P_, R_;  // c_i; of modes over h/2
};

class CoupledFlight {
 public:
  // tolerance [-] > 0 of a step; the body must outlive this
  CoupledFlight(const FloatingBody& body, const BodyState& start, double t0, double tolerance = 1e-9);

  // State at t [s] >= t0; steps are taken as far as they are asked for: one thread at a time. Where no step is
  // small enough, as where the rotation tears the body apart, the last state that was reached.
  BodyState at(double t) const;
  bool failed() const { return failed_; }
  long n_steps() const { return n_steps_; }

 private:
  struct Node {
    double t;  // [s]
    BodyState state;
  };
  void extend() const;
  double longest_until_jump() const;         // [s] of a step from end_ on
  const CoupledFlow& flow(int level) const;  // over longest_ 2^-level

  const FloatingBody& body_;
  double tolerance_, longest_;
  mutable std::map<int, CoupledFlow> flows_;
  mutable std::vector<Node> nodes_;
  mutable double end_;
  mutable BodyState last_;  // at end_
  mutable int level_ = 0;
  mutable long n_steps_ = 0;
  mutable bool failed_ = false;
};

}  // namespace mb
