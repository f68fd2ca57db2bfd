#include "modal/contact/contact_shapes.h"

#include <algorithm>
#include <cmath>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/geometry/signed_distance.h"
#include "mechanics/system/static_response.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr int n_discs = 9;  // of radius 2a, 2a/sqrt(2), a, ... a/8
const double ratio = std::sqrt(0.5);
constexpr int n_more = (n_discs + 1) / 2;  // every other one
constexpr double lever = 0.05;       // [-] of the size: by how much a blow misses the centroid of a body that it turns
constexpr double facing = 0.5;       // [-] cosine of a surface that meets the obstacle
constexpr double independent = 1e-8; /* [-] of the largest energy */
constexpr double left_over = 1e-14;  // [-] of the whole response's energy: rounding, where the modes have all of it

bool turned_by_blow(const Body& body, const Vector3d& X) {
  return X.cross(signed_distance(body.shape, X).gradient).norm() > lever * extent(body.shape);
}

// Whether either of the two rolls on the other.
bool rolls(const Scene& scene, const Body& body, const TouchedAt& at) {
  if (turned_by_blow(body, at.X)) return true;
  const ContactPair& pair = scene.contacts.at(at.meeting.contact);
  const Body* const met = partner_of(scene, pair);
  if (met == nullptr) return false;
  if (met->name != body.name) return turned_by_blow(*met, at.meeting.Y);
  const auto comes = [&](const Body& other) { return other.name == pair.body; };
  return turned_by_blow(*std::ranges::find_if(scene.bodies, comes), at.meeting.X);
}

// One column a disc: the nodal forces of its pressure along the inward normal; every other disc once more with
// pressures that tilt, p x/a and p y/a, where the body rolls off it or, what friction rubs at its base, leans; and
// where friction rubs along either tangent.
MatrixXd disc_forces(const Body& body, const FullModel& full, const TouchedAt& at, bool tilts, bool rubs) {
  const double largest = std::min(2 * at.meeting.size.radius, 0.5 * extent(body.shape));
  const double smallest = largest * std::pow(ratio, n_discs - 1);
  const Vector3d inward = -signed_distance(body.shape, at.X).gradient;
  const Vector3d along = inward.unitOrthogonal(), across = inward.cross(along);
  const GradedRule rule = graded_rule(body.shape, {at.X}, {smallest / 4, largest / 4, 0.25, 3}, largest);
  const Index n_tilting = tilts ? 2 * n_more : 0, n_rubbing = rubs ? 2 * n_more : 0;
  MatrixXd p = MatrixXd::Zero(3 * rule.weights.size(), n_discs + n_tilting + n_rubbing);
  for (Index i = 0; i < rule.weights.size(); ++i) {
    // Faces around an edge do not touch.
    if (signed_distance(body.shape, rule.points.col(i)).gradient.dot(inward) > -facing) continue;
    const double distance = (rule.points.col(i) - at.X).norm();
    double a = largest;
    for (int k = 0; k < n_discs && distance < a; ++k, a *= ratio) {
      const double share = rule.weights[i] * std::sqrt(1 - distance * distance / (a * a));
      p.block<3, 1>(3 * i, k) = share * inward;
      if (!tilts || k % 2 == 1) continue;
      const Vector3d arm = (rule.points.col(i) - at.X) / a;
      p.block<3, 1>(3 * i, n_discs + k) = share * arm.dot(along) * inward;
      p.block<3, 1>(3 * i, n_discs + k + 1) = share * arm.dot(across) * inward;
      if (!rubs) continue;
      p.block<3, 1>(3 * i, n_discs + n_tilting + k) = share * along;
      p.block<3, 1>(3 * i, n_discs + n_tilting + k + 1) = share * across;
    }
  }
  return full.displacement_at(rule.points).transpose() * p;
}

// Of law hertz the one force there is, on the body and on what strikes it.
MatrixXd point_force(const Scene& scene, const Body& body, const FullModel& full, const Meeting& meeting) {
  const RigidSurface surface = surface_met(scene, body, meeting);
  const Vector3d normal = surface.pose.orientation * Vector3d::UnitZ();
  return full.contact_points(surface, 0).U.transpose() * normal;
}

}  // namespace

MatrixXd contact_shapes(const Scene& scene, const Body& body, const BodyModel& model, const Modes& modes,
                        double shift) {
  const System& system = model.full->system();
  MatrixXd F(system.u0.size(), 0);
  for (const TouchedAt& at : touched_at(scene, body)) {
    if (!std::isfinite(at.meeting.t)) continue;
    const ContactPair& pair = scene.contacts.at(at.meeting.contact);
    const bool lumped = pair.law == ContactLaw::hertz, rubs = pair.friction > 0;
    const MatrixXd forces = lumped ? point_force(scene, body, *model.full, at.meeting)
                                   : disc_forces(body, *model.full, at, rubs || rolls(scene, body, at), rubs);
    F.conservativeResize(Eigen::NoChange, F.cols() + forces.cols());
    F.rightCols(forces.cols()) = forces;
  }
  if (F.cols() == 0) return F;
  const MatrixXd G_F = inertia_relief(system, shifted_factor(system, shift), F);
  MatrixXd Psi = residual_flexibility(modes, F, G_F);
  const auto energies = [&](const MatrixXd& shapes) {
    return VectorXd((shapes.transpose() * (system.K * shapes)).diagonal());
  };
  const VectorXd energy = energies(Psi), whole = energies(G_F);
  std::vector<Index> missing;  // from the modes
  for (Index k = 0; k < Psi.cols(); ++k)
    if (energy[k] > left_over * whole[k]) missing.push_back(k);
  if (missing.empty()) return MatrixXd(F.rows(), 0);
  Psi = MatrixXd(Psi(Eigen::all, missing)) * energy(missing).cwiseSqrt().cwiseInverse().asDiagonal();
  const EigenPairs eigen = symmetric_eigen(Psi.transpose() * (system.K * Psi));
  std::vector<Index> kept;
  for (Index k = 0; k < Psi.cols(); ++k)
    if (eigen.values[k] > independent * eigen.values.maxCoeff()) kept.push_back(k);
  return Psi * eigen.vectors(Eigen::all, kept) * eigen.values(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace mb
