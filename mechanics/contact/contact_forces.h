// Contact forces on the unknowns that they act on, C of n:
//
//   f_C = sum_i w_i D_i^T t_i,   K_x = df/du,  K_v = df/du' (both negative semi-definite without friction)
//
// Where an obstacle is a half-space without friction, each point has one row, its normal component; else three; the
// nodes of another body's boundary follow with three each.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "mechanics/contact/contact.h"

namespace mb {

struct ContactSum {
  double least_gap;           // [m] over all points; infinity without points
  Vector3d force;             // [N] on the bodies whose points are looked at
  double stored, dissipation; /* [J] in the layer; [W] lost in it and to friction, >= 0 */
};

class ContactForces {
 public:
  // Contacts must outlive this; their points share n columns.
  explicit ContactForces(const std::vector<Contact>& contacts);
  const std::vector<Index>& dofs() const { return dofs_; }  // C, ascending

  // Of the displacements and velocities of C [m], [m/s]; f [N] gets the size of C. No allocation once it has it.
  ContactSum operator()(const VectorXd& u, const VectorXd& v, VectorXd& f) const;

  // The same, with the tangents K_x [N/m] and K_v [N s/m] on the rows of C that feel a force: `active`, places in C.
  struct Tangent {
    std::vector<Index> active;
    MatrixXd by_u, by_v;
  };
  ContactSum operator()(const VectorXd& u, const VectorXd& v, VectorXd& f, Tangent& tangent) const;

  bool meet() const;                                                   // any contact's surfaces, at the start
  VectorXd gather(const VectorXd& x) const { return x(dofs_); }        // n -> C
  void add(const VectorXd& f, VectorXd& to) const { to(dofs_) += f; }  // C -> n

 private:
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  struct Part {
    const Contact* contact;
    bool flat = false;   // one row a point
    Rows D = {};         // rows m, 3 m or, with k nodes of a partner, 3 (m + k); columns |C|
    VectorXd gap0 = {};  // [m] of a flat one at u = 0
    Vector3d normal = Vector3d::Zero();
    mutable std::optional<FootSearch> feet = {};  // on a partner
    mutable VectorXd y = {}, rate = {}, t = {};   // of every row
    mutable std::vector<Index> touching = {};
    mutable std::vector<FacetFoot> at = {};                     // of touching points on a partner
    mutable std::vector<Eigen::Matrix3d> by_x = {}, by_v = {};  // of touching points
  };
  using Row = std::vector<std::pair<Index, double>>;  // column in C, entry
  ContactSum evaluate(const VectorXd& u, const VectorXd& v, VectorXd& f, bool with_tangent) const;
  static void flat_tractions(const Part& part, ContactSum& sum, bool with_tangent);
  static void tractions(const Part& part, ContactSum& sum, bool with_tangent);
  static void tractions_between(const Part& part, ContactSum& sum, bool with_tangent);
  static void push(const Part& part, Index i, const Traction3& t, const Gap& at, const Vector3d& v, ContactSum& sum);
  static void relative_row(const Part& part, size_t touching, Index component, Row& row);
  void assemble(Tangent& tangent) const;

  std::vector<Index> dofs_;
  std::vector<Part> parts_;
  mutable std::vector<Index> place_;  // in Tangent::active of a place in C, or -1
};

}  // namespace mb
