// Rotation and modes of a free body with coupling (spin.h) away from all obstacles: what couples them has no closed
// form.
//
//   y = (q, pi, Q),    y' = A y + b + (n(y) - b),    A, b: the free modes under the force that spin has at the start
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

#include "modal/contact/spin.h"

namespace mb {

class CoupledFlow {
 public:
  CoupledFlow(const FloatingBody& body, double h);  // h [s] >= 0; the body must outlive this
  BodyState advance(BodyState state) const;         // its Q, q and p; c, v and s stay as they are

 private:
  struct Slope {
    VectorXd q, p;  // n - b
    Eigen::Vector4d Q;
  };
  Slope slope(const BodyState& y, const VectorXd& b) const;
  BodyState flow(const BodyState& y, const VectorXd& b) const;     // of A y + b over h/2
  Slope flow(const Slope& x) const;                                // of A y over h/2
  static BodyState add(BodyState y, const Slope& x, double part);  // y + part x

  const FloatingBody& body_;
  double h_;
  VectorXd damping_, C_, S_, C_dot_, S_dot_, P_;  // c_i; of modes over h/2
};

class CoupledFlight {
 public:
  // tolerance [-] > 0 of a step; the body must outlive this
  CoupledFlight(const FloatingBody& body, const BodyState& start, double t0, double tolerance = 1e-9);

  // Q, q and p at t [s] >= t0; steps are taken as far as they are asked for: one thread at a time. Where no step is
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
