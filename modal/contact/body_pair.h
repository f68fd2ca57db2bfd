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
  // Throws std::runtime_error where they come close outside the box in which b's modes are known (floating_body.h).
  void look(const Moving& a, const Moving& b);  // what follows but `shaking` is of these, which must live on for it
  double least_gap() const;  // [m] of the samples looked at, but for the static shapes; infinity: none is in reach
  double clearance() const { return clearance_; }  // [m] a lower bound of all samples' gaps, likewise
  // [m/s] of both surfaces where they were nearest, from these states on (meetings.h).
  double shaking(const Moving& a, const Moving& b) const;
  // s = (s_a, s_b): adds what the static shapes feel to f_s and what it loses by s to H.
  void push(const VectorXd& s, VectorXd& f_s, MatrixXd& H);
  bool covers(const VectorXd& s);
  void act(const VectorXd& s, ContactLoad& a, ContactLoad& b);
  // Adds -df/dz - rate df/dz' for z = (frame and modes of a, of b, s_a, s_b).
  void stiffen(const VectorXd& s, double rate, MatrixXd& K);

 private:
  struct Near {        // a sample in reach
    Vector3d x, v, n;  // [m], [m/s] relative to its foot, world; but for the static shapes
    Vector3d Y, y;     // [m] of b's frame, of its deformed shape there
    double gap;        // [m]
  };
  VectorXd gaps() const;
  Vector3d within_box(const Vector3d& Y, double larger) const;
  void find_foot(Index i, Near& near) const;
  Eigen::Matrix<double, 3, Eigen::Dynamic> rows(Index i) const;  // x - x_b by s
  struct Pressing {
    double value;
    Vector3d x;
    Traction3 t;
  };
  std::optional<Pressing> press(Index k, const VectorXd& s) const;

  const FloatingBody &a_, &b_;
  const SampledContact& contact_;
  const PartnerSurface& surface_;
  Reach reach_;
  std::shared_ptr<const SampleTables> tables_;
  const MatrixXd &Phi_, &Psi_;  // r x 3 m, n_s x 3 m, of a
  const MatrixXd& Psi_b_;       // n_s x 3 m
  Matrix3Xd feet_;              // [m] the last of each sample
  std::vector<Near> near_;
  double clearance_ = 0;  // [m]
  Index n_ = 0;
  Moving at_a_{}, at_b_{};
  Eigen::Matrix3d Q_a_, Q_b_;
  std::optional<PolynomialMap> map_, rate_;  // of b
};

}  // namespace mb
