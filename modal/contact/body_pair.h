// One body against another, as sampled_pair.h has it against an obstacle. Sample i of body a, at x, meets the surface
// of body b, the shape carried by its modes, in a foot Y of b's frame:
//
//   x_b(Y) = c_b + Q_b (Y + sum_k q_k phi_k(Y)),   n = F^-T grad d / |F^-T grad d|,   F = 1 + grad u_b,
//   gap = n . (x - x_b(Y)),   Y = P(Y + F^-1 Q_b^T (x - x_b(Y))),   P the projection onto the shape at rest
//
// Both bodies feel one force at one point, x: momenta are handed over to rounding. What b's modes get of it is
//   sum_i Phi(Y_i)^T Q_b^T f_i = A^T vec(sum_i Q_b^T f_i m(Y_i)^T),   A the coefficients of its modes, m the monomials:
// one small product however many modes there are.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "modal/contact/contact_load.h"
#include "modal/contact/reach.h"
#include "modal/contact/sample_tree.h"

namespace mb {

class BodyPair {
 public:
  // The bodies and the contact of a, which names its partner b, must outlive this.
  BodyPair(const FloatingBody& a, const FloatingBody& b, const SampledContact& contact);

  // Of one body a state and its angular velocity [rad/s] in the world.
  struct Moving {
    const BodyState* state;
    Vector3d Omega;
    const VectorXd* rate;  // q'
  };
  // Where the two are nearest, roughly.
  struct Nearest {
    double clearance;  // [m] a lower bound of all samples' gaps, but for the static shapes; NaN where states are none
    Index sample;
    Vector3d normal;  // [-] of b, world, but for strain
    Vector3d Y;       // [m] foot, likewise, in b's frame, within the box in which its modes are known
  };
  Nearest nearest(const BodyState& a, const BodyState& b);
  // [m/s] of both surfaces there along directions of which the normal counts in full, others by `aside` (meetings.h).
  double shaking(const Nearest& at, const Moving& a, const Moving& b, double aside) const;

  // Throws std::runtime_error where they come close outside the box in which b's modes are known (floating_body.h).
  void look(const Moving& a, const Moving& b);  // what follows is of these, which must live on for it
  double least_gap() const;  // [m] of the samples looked at, but for the static shapes; infinity: none is in reach
  // s = (s_a, s_b): adds what the static shapes feel to f_s and what it loses by s to H.
  void push(const VectorXd& s, VectorXd& f_s, MatrixXd& H);
  bool covers(const VectorXd& s);
  void act(const VectorXd& s, ContactLoad& a, ContactLoad& b);
  // Adds -df/dz - rate df/dz' for z = (frame and modes of a, of b, s_a, s_b).
  void stiffen(const VectorXd& s, double rate, MatrixXd& K);

 private:
  // Samples in reach, in the order of the list; what belongs to a sample stands together. All but for static shapes.
  struct Near {
    MatrixXd Phi, Psi, Psi_b;  // r x 3 m, n_s x 3 m, n_s x 3 m of b: gathered as they come into reach
    Matrix3Xd x, v, n;         // [m], [m/s] relative to the foot, [-]; world
    Matrix3Xd Y, y;            // [m] of b's frame, of its deformed shape there
    VectorXd gap;              // [m]
    MatrixXd gap_by_s;         // [m] n_s of both x m
    void reserve(Index m);
  };
  void meet(const BodyState& a, const BodyState& b);  // takes in frames and the map of b
  ListSize shortest() const { return {1, 0, 0}; }
  Neighbours neighbours(const BodyState& a, const BodyState& b, const ListSize& size);
  Vector3d in_partner(Index i) const;  // y of sample i less what static shapes of b move there
  double bound(const SampleTree::Extent& of) const;
  Vector3d within_box(const Vector3d& Y, double larger) const;
  void gather();
  void find_feet();
  void draw_feet_to(const Matrix3Xd& target);  // [m] places of the samples in the partner's frame
  void find_rates(const PolynomialMap& rate);
  Matrix3Xd rows(Index k) const;                     // x - x_b by s, 3 x n_s of both
  Vector3d moved(Index k, const VectorXd& s) const;  // [m] of the sample itself by its static shapes, world
  Vector3d traction(Index k, double gap) const;      // [Pa] world

  const FloatingBody &a_, &b_;
  const SampledContact& contact_;
  const PartnerSurface& surface_;
  Reach reach_;
  std::shared_ptr<const SampleTables> tables_;
  std::shared_ptr<const SampleTree> tree_;
  bool feels_rates_;  // the law
  Matrix3Xd feet_;    // [m] the last of each sample
  Near near_;
  Index n_ = 0, n_gathered_ = 0;
  long list_ = 0;
  Moving at_a_{}, at_b_{};
  Eigen::Matrix3d Q_a_, Q_b_, turn_;  // turn: from a's axes to b's
  Vector3d apart_;                    // [m] of a's centre, b's frame
  std::optional<PolynomialMap> map_;  // of b
  double strain_ = 0;                 // [-] of it, at most
};

}  // namespace mb
