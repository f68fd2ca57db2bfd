// The nonlinear equation of an implicit step with contact,
//
//   A v = b + gamma f(u, v),   u = a + gamma v,   A = M + gamma C + gamma^2 K
//
// condensed onto the unknowns C that contact forces act on, so that the sparse factor of A serves unchanged:
//
//   v_C = vhat_C + gamma G f_C(u_C, v_C),   vhat = A^-1 b,   G = (A^-1)_CJ
//
// by Newton's method in the components J that feel a force, with a line search on the residual. Columns of A^-1 are
// found when they are first needed and kept as long as A is. The elastic compliance of the body turns the penalty's
// stiffness into a well-conditioned small dense system; no iteration over the whole mesh is left.
#pragma once

#include "mechanics/algebra/inverse.h"
#include "mechanics/contact/contact_forces.h"

namespace mb {

class ContactStage {
 public:
  // Both must outlive this.
  ContactStage(const ContactForces& forces, Index n)
      : forces_(forces),
        n_(n),
        column_(forces.dofs().size(), -1),
        inverse_(n, 0),
        inverse_C_(static_cast<Index>(forces.dofs().size()), 0) {}

  void forget();  // A has changed: its columns are void

  struct Outcome {
    bool converged;
    int iterations;
    long solves;     // with A
    ContactSum sum;  // of the very forces that the solution feels: within the tolerance those in it
  };
  // v: vhat on entry, the solution on return. tolerance [m/s]: of the largest component of the residual.
  Outcome solve(const Inverse& A, const VectorXd& a, double gamma, double tolerance, VectorXd& v);
  const VectorXd& force() const { return f_; }  // [N] of C, that the last solution feels: outcome.sum is of these

 private:
  void require_columns(const Inverse& A, const std::vector<Index>& active, Outcome& outcome);
  MatrixXd compliance(const std::vector<Index>& rows, const std::vector<Index>& columns) const;
  VectorXd response(const VectorXd& f_C) const;  // (A^-1 f)_C

  const ContactForces& forces_;
  Index n_;
  std::vector<Index> column_;  // of a place in C: its column in inverse_, or -1
  std::vector<Index> known_;   // places in C of the columns
  VectorXd f_;
  MatrixXd inverse_, inverse_C_;  // A^-1 e_j: n x known, |C| x known
};

}  // namespace mb
