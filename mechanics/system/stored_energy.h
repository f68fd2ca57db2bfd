// What holds a body together where K u is not enough: a stored energy W of finite deformation and its viscosity,
//
//   f(u, v) = dW/du + D(u) v,    K_T = d2W/du2,    K_T(0) = K,   D(0) = beta K,   v^T D v >= 0
//
// Rigid motions, however large, change neither W nor f but for its direction, and D does not brake them:
//
//   W(Q u + c) = W(u),   f(Q u + c, Q v + ...) = Q f(u, v),   D(u) r = 0 for rigid velocities r at x = X + u
//
// A deformation inverts where its Jacobian is not positive somewhere: W is infinite there and f has no value.
#pragma once

#include <memory>
#include <vector>

#include "mechanics/types.h"

namespace mb {

struct System;

// Of a body without supports: of unknowns [first, first + n), in threes, Q minimises int rho |x - c - Q (X - X_c)|^2.
struct Turn {
  Index first, n;
  Eigen::Matrix3d Q;
};

// One object may serve several threads.
class StoredEnergy {
 public:
  virtual ~StoredEnergy() = default;

  virtual double energy(const VectorXd& u) const = 0;  // W [J]; infinity where it inverts
  // f [N] of u [m] and v [m/s], n each. false: it inverts, and f is not to be used.
  virtual bool force(const VectorXd& u, const VectorXd& v, VectorXd& f) const = 0;
  // A += by_u K_T(u) + by_v D(u), A symmetric with the pattern of the system's K. false: it inverts, A is void.
  virtual bool add_tangent(const VectorXd& u, double by_u, double by_v, SparseMatrix& A) const = 0;

  virtual std::vector<Turn> turns(const VectorXd& u) const = 0;  // of what is held none
  // n x m: rigid velocities that the supports leave free, about the present places x = X + u; [-] and [m].
  virtual MatrixXd rigid_motions(const VectorXd& u) const = 0;
};

// Q of a single body; 1 where it is held.
inline Eigen::Matrix3d rotation(const StoredEnergy& energy, const VectorXd& u) {
  const std::vector<Turn> turns = energy.turns(u);
  return turns.empty() ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : turns.front().Q;
}

// Throws std::invalid_argument, naming the integrator, for a system with a stored energy: it would take K for it.
void require_linear(const System& system, const char* integrator);

}  // namespace mb
