// One body of a scene with contact in full order: what of its motion is not the joint integrator's.
//
//   x = c0 + Q0 (X + d(t) + u),   d rigid flight up to the joint start, in closed form; of a body that is held d = 0,
//                                 and before the joint start u is integrated alone: its weight bends it
//
// Linear kinematics carry small rotations. Finite ones (fem/finite_strain.h) carry any, every face of the boundary is
// watched, and a body that spins at the start stretches in flight: it is integrated from t = 0, where it is undeformed
// and moves rigidly. Strains of free finite bodies are those seen from a frame that turns with them, which metrics
// compare with small ones:
//
//   eps = sym(Q^T F) - 1,   Q minimises int rho |x - c - Q (X - X_c)|^2
#pragma once

#include <memory>
#include <vector>

#include "cases/contract/linear.h"
#include "cases/contract/touchdown.h"

namespace mb {

class ImpactMember {
 public:
  // The model must outlive this. Throws std::invalid_argument for a linear body that spins at the start.
  ImpactMember(const Model& model, size_t i);
  void start_at(double t, const Integrator& integrator, const Settings& settings);  // [s] of the joint integration

  const Body& body() const { return *body_; }
  const FullModel& full() const { return *full_; }
  bool free() const { return free_; }
  bool finite() const { return body_->kinematics == Kinematics::finite; }
  bool spins() const { return free_ && !body_->twist.angular_velocity.isZero(0); }
  const Touchdown& touchdown() const { return touchdown_; }
  const Matrix3Xd& points() const { return points_; }
  const System& system() const { return system_; }  // with the state at the joint start
  double kinetic_energy(const VectorXd& v) const { return v.dot(mass() * v) / 2; }  // [J] by the mass that is stepped
  Index n() const { return system_.u0.size(); }
  Pose frame() const;  // of the undeformed body at the joint start

  // Before the joint start: u [m] n x n_t at times t [s], all below it; zeros of a free body, of one that has settled
  // what its weight makes.
  States before(const VectorXd& t) const;
  // Of u: x - X at the evaluation points, of a body that is held in the world's axes alone: 3 p x n_t.
  MatrixXd displacement(const MatrixXd& u, const VectorXd& t) const;
  MatrixXd strain(const MatrixXd& u) const;    // at the evaluation points, 6 p x n_t
  MatrixXd rotation(const MatrixXd& u) const;  // [rad] 3 x n_t, R R^T M u's; of a linear body
  VectorXd weight() const;                     // [N]
  // [J] kinetic, strain and the weight's since t = 0, of states at the joint start or later. Here and in the momentum
  // by the mass that is stepped, which of explicit schemes is the lumped one: what these keep is no other's.
  VectorXd energy(const MatrixXd& u, const MatrixXd& v) const;
  double energy_at_start() const;  // [J] kinetic, of the body as the scene states it
  // 6 x n_t of a free body, as BodyTrajectory has it; before the joint start that of rigid flight, whatever v there.
  // 0 columns of a body in a basis, whose unknowns are at no places.
  MatrixXd momentum(const MatrixXd& u, const MatrixXd& v, const VectorXd& t) const;

  // Where it may touch, in the world as at the joint start, with columns from `first` on of n_all.
  ContactPoints contact_points(const RigidSurface& met, double reach, Index first, Index n_all) const;
  Facets facets(const RigidSurface& met, double reach, Index first, Index n_all) const;

 private:
  VectorXd rigid_velocity(double t) const;  // [m/s] n, of a free body
  const SparseMatrix& mass() const { return lumped_ ? system_.lumped_mass : system_.M; }
  Vector3d sum_of(const SparseMatrix& M, const VectorXd& v) const;  // [N s] sum (M v)_i, of a free body
  Vector3d to_axes(const Vector3d& world) const { return body_->pose.orientation.conjugate() * world; }
  Vector3d flown(double t) const { return free_ ? Vector3d(t * velocity_ + t * t / 2 * gravity_) : Vector3d::Zero(); }
  SparseMatrix in_world(const SparseMatrix& U, Index first, Index n_all) const;

  const Body* body_;
  Matrix3Xd points_;
  Observation displacement_, strain_;
  std::shared_ptr<const FullModel> full_;
  Touchdown touchdown_;
  System system_;
  bool free_, lumped_ = false;
  double start_ = 0;
  Vector3d velocity_, gravity_;  // in the body's axes
  std::unique_ptr<Stepper> alone_;
};

}  // namespace mb
