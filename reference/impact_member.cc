#include "reference/impact_member.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "mechanics/system/stored_energy.h"
#include "reference/impact_limits.h"

namespace mb {

ImpactMember::ImpactMember(const Model& model, size_t i)
    : body_(&model.scene->bodies.at(i)),
      points_(model.bodies.at(i).points.all()),
      displacement_{model.bodies[i].displacement, {}},
      strain_{model.bodies[i].strain, {}},
      full_(model.bodies[i].full),
      touchdown_(model.scene->contacts.empty() ? Touchdown{} : mb::touchdown(*model.scene, *body_)),
      system_(full_->system()),
      free_(!is_held(*body_)) {
  if (!finite() && !body_->twist.angular_velocity.isZero(0))
    throw std::invalid_argument(
        "body '" + body_->name +
        "' spins: full order of linear kinematics has small rotations only, of kinematics 'finite' any");
  velocity_ = to_axes(body_->twist.velocity);
  gravity_ = to_axes(model.scene->gravity);
}

void ImpactMember::start_at(double t, const Integrator& integrator, const Settings& settings) {
  start_ = t;
  lumped_ = integrator.conditionally_stable && system_.lumped_mass.rows() > 0;
  if (free_) {
    system_.v0 = rigid_velocity(t);
    return;
  }
  if (!(t > 0) || body_->settled) return;
  alone_ = integrator.prepare(full_->system(), settings, t);
  const States bent = alone_->run(VectorXd::Constant(1, t));
  if (bent.status != Status::ok)
    throw std::runtime_error("body '" + body_->name + "' before it is touched: " + to_string(bent.status));
  system_.u0 = bent.u.col(0), system_.v0 = bent.v.col(0);
}

VectorXd ImpactMember::rigid_velocity(double t) const {
  VectorXd v = full_->translation(velocity_ + t * gravity_);
  if (!spins()) return v;
  const VectorXd X = full_->places();
  const Vector3d omega = to_axes(body_->twist.angular_velocity);
  for (Index i = 0; i < v.size(); i += 3) v.segment<3>(i) += omega.cross(Vector3d(X.segment<3>(i)));
  return v;
}

Pose ImpactMember::frame() const { return {body_->pose.to_world(flown(start_)), body_->pose.orientation}; }

States ImpactMember::before(const VectorXd& t) const {
  if (alone_ && t.size() > 0) return alone_->run(t);
  States still;
  still.v = MatrixXd::Zero(n(), t.size());
  still.u = free_ ? still.v : full_->system().u0.replicate(1, t.size()).eval();
  still.n_valid = t.size();
  return still;
}

MatrixXd ImpactMember::displacement(const MatrixXd& u, const VectorXd& t) const {
  MatrixXd values = observe(displacement_, u, {});
  const Eigen::Matrix3d Q = body_->pose.orientation.toRotationMatrix();
  for (Index k = 0; k < t.size(); ++k) {
    const Vector3d d = flown(std::min(t[k], start_));
    for (Index i = 0; i < points_.cols(); ++i) {
      auto x = values.col(k).segment<3>(3 * i);
      x = free_ ? Vector3d(body_->pose.position + Q * (points_.col(i) + d + x) - points_.col(i)) : Vector3d(Q * x);
    }
  }
  return values;
}

MatrixXd ImpactMember::strain(const MatrixXd& u) const {
  if (!finite() || !free_) return observe(strain_, u, {});
  const Matrix3Xd X = full_->places().reshaped(3, n() / 3);
  MatrixXd seen(u.rows(), u.cols());  // Q^T (X + u) - X
  for (Index k = 0; k < u.cols(); ++k) {
    const Eigen::Matrix3d Q = mb::rotation(*system_.stored_energy, u.col(k));
    const Matrix3Xd x = X + u.col(k).reshaped(3, X.cols());
    seen.col(k) = (Q.transpose() * x - X).reshaped();
  }
  return observe(strain_, seen, {});
}

MatrixXd ImpactMember::rotation(const MatrixXd& u) const {
  return rotation_rows(system_, points_, observe(displacement_, system_.R, {})) * u;
}

VectorXd ImpactMember::weight() const {
  return free_ ? VectorXd(system_.M * full_->translation(gravity_)) : VectorXd(system_.F.rowwise().sum());
}

VectorXd ImpactMember::energy(const MatrixXd& u, const MatrixXd& v) const {
  const VectorXd load = weight();
  const double fallen = free_ ? full_->translation(flown(start_)).dot(mass() * full_->translation(gravity_)) : 0;
  VectorXd E = VectorXd::Constant(u.cols(), -fallen);
  for (Index k = 0; k < u.cols(); ++k)
    E[k] += kinetic_energy(v.col(k)) + strain_energy(system_, u.col(k)) - load.dot(u.col(k));
  return E;
}

double ImpactMember::energy_at_start() const { return kinetic_energy(free_ ? rigid_velocity(0) : full_->system().v0); }

Vector3d ImpactMember::sum_of(const SparseMatrix& M, const VectorXd& v) const {
  return VectorXd(M * v).reshaped(3, v.size() / 3).rowwise().sum();
}

// P = sum (M v)_i,  L = sum x_i x (M v)_i over the nodes: shapes sum to one, and carry rotations as they carry places.
// The weight is that of the mass in flight and from the joint start on the load, which is the consistent mass's.
MatrixXd ImpactMember::momentum(const MatrixXd& u, const MatrixXd& v, const VectorXd& t) const {
  const VectorXd places = full_->places();
  if (places.size() != n()) return {};  // unknowns of a basis
  const Matrix3Xd X = places.reshaped(3, n() / 3);
  const Eigen::Matrix3d Q = body_->pose.orientation.toRotationMatrix();
  const VectorXd falling = full_->translation(gravity_);
  const Vector3d in_flight = sum_of(mass(), falling), as_load = sum_of(system_.M, falling);
  MatrixXd all(6, t.size());
  for (Index k = 0; k < t.size(); ++k) {
    const bool flies = t[k] <= start_;
    const Matrix3Xd p = VectorXd(mass() * (flies ? rigid_velocity(t[k]) : VectorXd(v.col(k)))).reshaped(3, X.cols());
    const Matrix3Xd x = X + u.col(k).reshaped(3, X.cols());
    const double flown_for = std::min(t[k], start_);
    const Vector3d P = Q * p.rowwise().sum(), at = body_->pose.to_world(flown(flown_for));
    Vector3d spin = Vector3d::Zero();
    for (Index i = 0; i < x.cols(); ++i) spin += Vector3d(x.col(i)).cross(Vector3d(p.col(i)));
    all.col(k) << P - Q * (flown_for * in_flight + (t[k] - flown_for) * as_load), Q * spin + at.cross(P);
  }
  return all;
}

SparseMatrix ImpactMember::in_world(const SparseMatrix& U, Index first, Index n_all) const {
  const Eigen::Matrix3d Q = body_->pose.orientation.toRotationMatrix();
  std::vector<Eigen::Triplet<double>> entries;
  for (Index j = 0; j < U.outerSize(); ++j)
    for (SparseMatrix::InnerIterator it(U, j); it; ++it)
      for (Index i = 0; i < 3; ++i)
        if (const double part = Q(i, it.row() % 3); part != 0)
          entries.emplace_back(it.row() / 3 * 3 + i, first + j, part * it.value());
  SparseMatrix all(U.rows(), n_all);
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

namespace {

Matrix3Xd to_world(const Pose& frame, const Matrix3Xd& X) {
  return (frame.orientation.toRotationMatrix() * X).colwise() + frame.position;
}

}  // namespace

ContactPoints ImpactMember::contact_points(const RigidSurface& met, double reach, Index first, Index n_all) const {
  ContactPoints all = finite() ? full_->boundary() : full_->contact_points(seen_from(frame(), met), reach);
  all.X = to_world(frame(), all.X);
  all.U = in_world(all.U, first, n_all);
  return all;
}

Facets ImpactMember::facets(const RigidSurface& met, double reach, Index first, Index n_all) const {
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  Facets all = full_->facets(seen_from(frame(), met), finite() ? everywhere : reach);
  all.X = to_world(frame(), all.X);
  all.U = in_world(all.U, first, n_all);
  return all;
}

}  // namespace mb
