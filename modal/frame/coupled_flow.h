// Rotation and modes of a free body with coupling (spin.h) or loads (frame_loads.h) away from all obstacles: what
// couples them has no closed form.
//
//   y = (q, pi, Q),    y' = A y + b + (n(y, t) - b),    A, b: the free modes under the force of spin and loads at the
//   start,             with loads y = (q, pi, Q, c, v, L):  c' = v,  m v' = Q force + m g,  L' = Q torque
//
// One step h is the classical Runge-Kutta method of order 4 in the variables that the exact flow of A y + b leaves
// constant (Lawson 1967, SIAM J. Numer. Anal. 4, 372-380): free vibration and steady stretching are exact whatever h,
// and without spin nothing is left to approximate.
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
    VectorXd q, p;  // n - b
    Eigen::Vector4d Q;
    Vector3d c, v, L;  // 0 without loads
  };
  struct Start {
    double t;
    VectorXd b;
  };
  Slope slope(const BodyState& y, double t, const Start& start) const;
  BodyState flow(const BodyState& y, const VectorXd& b) const;  // of A y + b over h/2
  Slope flow(const Slope& x) const;                             // of A y over h/2
  static Slope weighted(const Slope& k1, const Slope& k2, const Slope& k3, const Slope& k4);
  static BodyState add(BodyState y, const Slope& x, double part);  // y + part x

  const FloatingBody& body_;
  double h_;
  VectorXd damping_, C_, S_, C_dot_, S_dot_, P_;  // c_i; of modes over h/2
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
