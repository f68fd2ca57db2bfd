// The nonlinear equation of an implicit step of a body of finite deformation, in contact or not,
//
//   M v = b - gamma r(u, v) + gamma f_C(u, v),   u = a + gamma v,   r: the resistance of finite_force.h
//
// by Newton's method with a tangent that is kept, made at some u_0, and turned with the body, or each of them with its
// own:
//
//   A = (1 + gamma alpha) M + gamma D(u_0) + gamma^2 K_T(u_0),    A(Q u_0) = Q A Q^T
//
// Contact is condensed onto its own unknowns by columns of the inverse (contact_stage.h) and solved exactly in every
// iteration. A new tangent is made where an iteration leaves more than 0.3 of the error. Whatever A is, with it linear
// momentum is kept to rounding: A and M differ by what translations do not feel.
#pragma once

#include <list>
#include <optional>
#include <vector>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/contact/contact_stage.h"
#include "mechanics/system/finite_force.h"

namespace mb {

// Q A^-1 Q^T with the rigid modes' part of mass-proportional damping taken back (Sherman and Morrison's formula, exact
// for translations, near enough for rotations of a stressed body).
class TurnedInverse final : public Inverse {
 public:
  TurnedInverse(const System& system, const FiniteForce& force) : system_(&system), force_(&force) {}
  // Throws std::runtime_error where A is not positive definite. false: u inverts.
  bool make(const VectorXd& u, double gamma);
  // Whether Q was more than a fiftieth of a radian off that at u; Q is there now.
  bool turn(const VectorXd& u);

  void solve(const VectorXd& b, VectorXd& x) const override;
  MatrixXd columns(const std::vector<Index>& which, Index n) const override;

 private:
  void correct(const VectorXd& u);
  void turn_back(VectorXd& x) const;
  void turn_forth(Eigen::Ref<VectorXd> x) const;

  const System* system_;
  const FiniteForce* force_;
  double gamma_ = 0;
  std::optional<Cholesky> factor_;
  std::vector<Turn> made_at_, turned_by_;  // of u_0; from there to the present, empty: not at all
  MatrixXd R_;                             // n x m, or empty without alpha
  mutable VectorXd turned_;                // n
};

class FiniteStage {
 public:
  // contact: or nullptr. All must outlive this.
  FiniteStage(const System& system, const FiniteForce& force, const ContactForces* contact);

  void forget() { kept_.clear(); }  // tangents of an earlier run

  struct Outcome {
    bool converged = false, inverted = false;
    int iterations = 0;
    long solves = 0, factorisations = 0;
  };
  // v: a guess on entry, the solution on return. tolerance [m/s]: of the largest component of its error.
  // contact_tolerance [m/s]: to which contact balances in every iteration.
  // t [s]: of the loads that turn with the body.
  Outcome solve(double t, const VectorXd& b, const VectorXd& a, double gamma, double tolerance,
                double contact_tolerance, VectorXd& v);

 private:
  struct Kept {
    double gamma;
    TurnedInverse inverse;
    std::optional<ContactStage> contact;
    double rate;  // [-] by which the error falls in an iteration, as last seen
  };
  Kept* tangent_at(const VectorXd& u, double gamma, Outcome& outcome);
  bool renew(Kept& kept, const VectorXd& u, Outcome& outcome);
  bool iterate(Kept& kept, const VectorXd& a, double contact_tolerance, const VectorXd& v, Outcome& outcome);
  bool residual(double t, const VectorXd& b, const VectorXd& a, double gamma, const VectorXd& v);

  static constexpr size_t most = 3;
  const System& system_;
  const FiniteForce& force_;
  const ContactForces* contact_;
  std::list<Kept> kept_;  // the last one used first
  VectorXd u_, r_, f_, next_;
};

}  // namespace mb
