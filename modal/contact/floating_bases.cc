#include "modal/contact/floating_bases.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/contract/approach.h"
#include "cases/contract/physical_shift.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/geometry/signed_distance.h"
#include "mechanics/rigid/inertia.h"
#include "mechanics/system/static_response.h"
#include "modal/bases/eigenmodes.h"
#include "modal/contact/contact_shapes.h"
#include "modal/contact/sample_tables.h"
#include "modal/contact/sample_tree.h"
#include "modal/contact/surface_polynomials.h"
#include "modal/frame/frame_loads.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double grading = 0.35;  // [-] of the distance
constexpr int points_per_cell_edge = 2;
constexpr double partner_reach = 1;  // [-] of a body's extent: how far from the first touch it may meet its partner

SurfaceSamples samples(const Body& body, const FullModel& full, const Meeting& meeting, const PolynomialBasis& Phi,
                       const MatrixXd& Psi, double finest) {
  const double l = extent(body.shape);
  const Grading sizes{std::min(finest * meeting.size.radius, l / 8), l / 8, grading, points_per_cell_edge};
  GradedRule rule = graded_rule(body.shape, {meeting.X}, sizes);
  MatrixXd at = Phi.at(rule.points), static_at(at.rows(), Psi.cols());
  if (Psi.cols() > 0) static_at = full.displacement_at(rule.points) * Psi;
  return {std::move(rule.points), std::move(rule.weights), std::move(at), std::move(static_at)};
}

// Hertz's law, lumped in the points that the model has for it.
SurfaceSamples lumped(const FullModel& full, const RigidSurface& surface, const MatrixXd& Phi, const MatrixXd& Psi) {
  const ContactPoints points = full.contact_points(surface, 0);
  return {points.X, points.w, points.U * Phi, points.U * Psi};
}

std::vector<Roots> roots_of(const Modes& modes, Index n_first, const Rayleigh& damping) {
  std::vector<Roots> all;
  for (Index i = n_first; i < modes.size(); ++i) {
    const double lambda = modes.omega[i] * modes.omega[i];
    all.push_back(roots({lambda, lambda > 0 ? damping.alpha + damping.beta * lambda : 0}));
  }
  return all;
}

// Phi and Psi of the mesh, n x r and n x n_s.
struct Shapes {
  MatrixXd Phi, Psi;
};

// The other body's surface where the samples of one that comes to it lie at the first touch.
// Where bodies meet, not everywhere, are a partner's modes these polynomials. What they are bounded by holds for both,
// polynomials there and mesh everywhere.
void meet_near(FloatingBasis& partner, Regression near) {
  for (Index j = 0; j < std::ssize(near.modes); ++j) {
    const auto u = partner.displacement.col(j).reshaped(3, partner.points.cols());
    const double largest = u.colwise().norm().maxCoeff();
    double& bound = partner.bounds.value[j];
    bound = std::max(bound, (1 + near.modes[static_cast<size_t>(j)].largest_residual) * largest);
  }
  partner.geometry = std::move(near);
}

std::shared_ptr<const PartnerSurface> surface_of_partner(const Model& model, const Body& body, const Meeting& meeting,
                                                         const Matrix3Xd& samples, const FloatingBasis& other,
                                                         const MatrixXd& Psi) {
  const Body& partner = model.scene->bodies[other.place];
  const FullModel& full = *model.bodies[other.place].full;
  const Pose pose = Approach(*model.scene, body, &partner).pose(std::isfinite(meeting.t) ? meeting.t : 0);
  Matrix3Xd feet(3, samples.cols());
  for (Index i = 0; i < samples.cols(); ++i) {
    const Vector3d y = pose.to_world(samples.col(i));
    const Distance d = signed_distance(partner.shape, y);
    feet.col(i) = y - d.value * d.gradient;
  }
  MatrixXd static_at(3 * samples.cols(), Psi.cols());
  if (Psi.cols() > 0) static_at = full.displacement_at(feet) * Psi;
  return std::make_shared<const PartnerSurface>(
      partner_surface(other.place, partner.shape, other.geometry.basis, std::move(feet), static_at));
}

std::vector<SampledContact> sampled_contacts(const Model& model, FloatingBases& bases, size_t i,
                                             const std::vector<Shapes>& shapes, double finest) {
  const Scene& scene = *model.scene;
  const Body& body = scene.bodies[i];
  const FullModel& full = *model.bodies[i].full;
  std::vector<SampledContact> all;
  for (const Meeting& meeting : touchdown(scene, body).meetings) {
    const ContactPair& pair = scene.contacts[meeting.contact];
    const RigidSurface surface = surface_met(scene, body, meeting);
    const auto& [Phi, Psi] = shapes[i];
    all.push_back({pair.law == ContactLaw::hertz ? lumped(full, surface, Phi, Psi)
                                                 : samples(body, full, meeting, bases[i].geometry.basis, Psi, finest),
                   surface, law_of(pair, meeting.size)});
    all.back().tables = std::make_shared<const SampleTables>(sample_tables(all.back().samples));
    for (FloatingBasis& other : bases) {
      const Body& partner = scene.bodies[other.place];
      if (partner.name != pair.obstacle) continue;
      const auto& [Phi_other, Psi_other] = shapes[other.place];
      meet_near(other, polynomials_near(partner.shape, *model.bodies[other.place].full, Phi_other, meeting.Y,
                                        partner_reach * extent(body.shape)));
      all.back().partner = surface_of_partner(model, body, meeting, all.back().samples.X, other, Psi_other);
      all.back().tree = std::make_shared<const SampleTree>(sample_tree(all.back()));
    }
  }
  return all;
}

// Loads, in the place of contacts, from the axes of the start on.
void load(FloatingBasis& basis, const BodyModel& mesh, const Modes& modes, bool corrected) {
  const Scene& scene = *basis.scene;
  const Body& body = scene.bodies[basis.place];
  const System& system = mesh.full->system();
  const Eigen::Quaterniond to_start = body.pose.orientation.conjugate();
  basis.start.L = to_start * basis.start.L, basis.start.v = to_start * basis.start.v;
  basis.start.c.setZero(), basis.start.Q.setIdentity();
  basis.body.loads =
      std::make_shared<const FrameLoads>(frame_loads(system, mesh.full->places(), basis.Phi, scene.duration));
  if (!corrected) return;
  const MatrixXd G = load_patterns(system);
  const MatrixXd rest =
      residual_flexibility(modes, G, inertia_relief(system, shifted_factor(system, physical_shift(body)), G));
  basis.load_displacement = mesh.displacement * rest, basis.load_strain = mesh.strain * rest;
}

// All but its contacts.
FloatingBasis basis_of(const Model& model, size_t i, const Modes& modes, const Shapes& shapes) {
  const Body& body = model.scene->bodies[i];
  const BodyModel& mesh = model.bodies[i];
  const auto& [Phi, Psi] = shapes;
  const bool free = !is_held(body), in_flight = body.theory == Theory::solid;
  const Index r = Phi.cols();
  const System& system = mesh.full->system();
  const MassProperties inertia = mass_properties(body.shape, body.material.density);
  FloatingBasis basis{model.scene,
                      i,
                      {free,
                       inertia.mass,
                       inertia.inertia,
                       model.scene->gravity,
                       roots_of(modes, modes.size() - r, body.damping),
                       VectorXd::Zero(r),
                       Psi.transpose() * (system.K * Psi),
                       {},
                       body.damping.beta},
                      {body.pose.position, body.twist.velocity, body.pose.orientation, Vector3d::Zero(),
                       VectorXd::Zero(r), VectorXd::Zero(r), VectorXd::Zero(Psi.cols())},
                      polynomials_of(mesh, mesh.displacement * Phi.leftCols(in_flight ? r : 0)),
                      {},
                      mesh.points.all(),
                      mesh.displacement * Phi,
                      mesh.strain * Phi,
                      mesh.displacement * Psi,
                      mesh.strain * Psi,
                      {},
                      {},
                      mesh.full,
                      Phi};
  basis.bounds = shape_bounds(body.shape, basis.geometry.basis);
  if (!free) basis.body.weight = Phi.transpose() * system.F.rowwise().sum();
  if (body.settled)
    for (Index k = 0; k < r; ++k)
      if (const double lambda = basis.body.modes[static_cast<size_t>(k)].k; lambda > 0)
        basis.start.q[k] = basis.body.weight[k] / lambda;
  if (!free) basis.start.p = Phi.transpose() * (system.M * system.v0);
  const Eigen::Quaterniond& Q = body.pose.orientation;
  basis.start.L = Q * (inertia.inertia * (Q.conjugate() * body.twist.angular_velocity));
  return basis;
}

}  // namespace

bool turn_freely(const Scene& scene) {
  return scene.contacts.empty() && std::ranges::all_of(scene.bodies, [](const Body& body) {
           return body.kinematics == Kinematics::finite && !is_held(body);
         });
}

FloatingBases floating_bases(const Model& model, std::span<const Modes> modes, bool corrected, double finest) {
  const Scene& scene = *model.scene;
  if (modes.size() != scene.bodies.size()) throw std::invalid_argument("modes in contact: of every body its own");
  if (modes.size() > 1 && scene.contacts.size() > 1)
    throw std::invalid_argument("modes in contact: of several bodies one contact alone");
  std::vector<Shapes> shapes;
  FloatingBases bases;
  for (size_t i = 0; i < modes.size(); ++i) {
    const Body& body = scene.bodies[i];
    const Index n_first = is_held(body) ? 0 : modes[i].n_rigid;
    const MatrixXd& Phi = modes[i].Phi;
    shapes.push_back({Phi.rightCols(modes[i].size() - n_first),
                      corrected ? contact_shapes(scene, body, model.bodies[i], modes[i], physical_shift(body))
                                : MatrixXd(Phi.rows(), 0)});
    bases.push_back(basis_of(model, i, modes[i], shapes.back()));
    if (turn_freely(scene)) load(bases.back(), model.bodies[i], modes[i], corrected);
  }
  for (size_t i = 0; i < bases.size(); ++i) bases[i].body.contacts = sampled_contacts(model, bases, i, shapes, finest);
  return bases;
}

}  // namespace mb
