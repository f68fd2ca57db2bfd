#include "modal/contact/floating_answer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/graded_rule.h"
#include "mechanics/rigid/inertia.h"
#include "modal/bases/eigenmodes.h"
#include "modal/contact/contact_shapes.h"
#include "modal/contact/sample_tables.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double finest = 0.5, grading = 0.35;  // [-] of the contact's radius; of the distance
constexpr int points_per_cell_edge = 2;

// Of the elastic modes at the evaluation points inside and on the surface, about half the weight to either.
Regression polynomials(const BodyModel& mesh, const MatrixXd& Phi_at_points) {
  const auto& [volume, surface, probes] = mesh.points;
  Vector3d half = Vector3d::Zero();
  for (const Quadrature* rule : {&volume, &surface}) half = half.cwiseMax(rule->points.cwiseAbs().rowwise().maxCoeff());
  const Index n = volume.points.cols() + surface.points.cols();
  VectorXd w(n);
  w << volume.weights / volume.weights.sum(), surface.weights / surface.weights.sum();
  return regress(Monomials(max_polynomial_degree, Vector3d::Zero(), half), mesh.points.all().leftCols(n), w,
                 Phi_at_points.topRows(3 * n));
}

SurfaceSamples samples(const Body& body, const FullModel& full, const Meeting& meeting, const PolynomialBasis& Phi,
                       const MatrixXd& Psi) {
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

std::vector<SampledContact> sampled_contacts(const Model& model, const Touchdown& down, const PolynomialBasis& geometry,
                                             const MatrixXd& Phi, const MatrixXd& Psi) {
  const Scene& scene = *model.scene;
  const Body& body = scene.bodies.front();
  const FullModel& full = *model.bodies.front().full;
  std::vector<SampledContact> all;
  for (const Meeting& meeting : down.meetings) {
    const ContactPair& pair = scene.contacts[meeting.contact];
    const RigidSurface surface = surface_met(scene, body, meeting);
    all.push_back(
        {pair.law == ContactLaw::hertz ? lumped(full, surface, Phi, Psi) : samples(body, full, meeting, geometry, Psi),
         surface, law_of(pair, meeting.size)});
    all.back().tables = std::make_shared<const SampleTables>(sample_tables(all.back().samples));
  }
  return all;
}

}  // namespace

FloatingBasis floating_basis(const Model& model, const Modes& modes, bool static_contact) {
  const Scene& scene = *model.scene;
  const Body& body = scene.bodies.front();
  const BodyModel& mesh = model.bodies.front();
  const Touchdown down = touchdown(scene, body);
  const bool free = !is_held(body), in_flight = body.theory == Theory::solid;
  const Index n_first = free ? modes.n_rigid : 0, r = modes.size() - n_first;
  const MatrixXd Phi = modes.Phi.rightCols(r);
  const MatrixXd Psi =
      static_contact ? contact_shapes(scene, mesh, modes, physical_shift(body), down) : MatrixXd(modes.Phi.rows(), 0);
  const MassProperties inertia = mass_properties(body.shape, body.material.density);
  FloatingBasis basis{model.scene,
                      {free,
                       inertia.mass,
                       inertia.inertia,
                       scene.gravity,
                       {},
                       VectorXd::Zero(r),
                       Psi.transpose() * (mesh.full->system().K * Psi),
                       {}},
                      {body.pose.position, body.twist.velocity, body.pose.orientation, Vector3d::Zero(),
                       VectorXd::Zero(r), VectorXd::Zero(r), VectorXd::Zero(Psi.cols())},
                      polynomials(mesh, mesh.displacement * Phi.leftCols(in_flight ? r : 0)),
                      {},
                      mesh.points.all(),
                      mesh.displacement * Phi,
                      mesh.strain * Phi,
                      mesh.displacement * Psi,
                      mesh.strain * Psi};
  basis.bounds = shape_bounds(body.shape, basis.geometry.basis);
  basis.body.modes = roots_of(modes, n_first, body.damping);
  basis.body.static_damping = body.damping.beta;
  if (!free) basis.body.weight = Phi.transpose() * mesh.full->system().F.rowwise().sum();
  if (!free) basis.start.p = Phi.transpose() * (mesh.full->system().M * mesh.full->system().v0);
  const Eigen::Quaterniond& Q = body.pose.orientation;
  basis.start.L = Q * (inertia.inertia * (Q.conjugate() * body.twist.angular_velocity));
  basis.body.contacts = sampled_contacts(model, down, basis.geometry.basis, Phi, Psi);
  return basis;
}

ImpactPlan impact_plan(const FloatingBasis& basis, ContactScheme scheme, double step) {
  const Body& body = basis.scene->bodies.front();
  return {basis.body, body.shape, basis.geometry.basis,        basis.bounds, basis.start,
          scheme,     step,       body.theory == Theory::solid};
}

namespace {

class PreparedFloating final : public Prepared {
 public:
  PreparedFloating(std::shared_ptr<const FloatingBasis> basis, ContactScheme scheme, double step)
      : basis_(std::move(basis)), plan_(impact_plan(*basis_, scheme, step)) {}

  Trajectory simulate(const Sampling& sampling) const override {
    if (sampling.shutter != 0) throw std::invalid_argument("no exact means in contact");
    const Index n_t = sampling.t.size(), r = plan_.body.n_modes(), n_s = plan_.body.n_static();
    const ImpactMotion motion = impact_motion(plan_, sampling.t);
    Trajectory answer{sampling.t, {}, motion.work, motion.status};
    BodyTrajectory body;
    body.contact = motion.contact;
    if (sampling.reconstruct) {
      MatrixXd q = MatrixXd::Zero(r, n_t), s = MatrixXd::Zero(n_s, n_t);
      for (size_t k = 0; k < motion.states.size(); ++k) {
        q.col(static_cast<Index>(k)) = motion.states[k].q;
        s.col(static_cast<Index>(k)) = motion.states[k].s;
      }
      body.displacement.noalias() = basis_->displacement * q;
      if (n_s > 0) body.displacement.noalias() += basis_->static_displacement * s;
      for (size_t k = 0; k < motion.states.size(); ++k)
        place(motion.states[k], body.displacement.col(static_cast<Index>(k)));
      if (sampling.strain) {
        body.strain = basis_->strain * q;
        if (n_s > 0) body.strain.noalias() += basis_->static_strain * s;
        body.energy = motion.energy;
      }
    }
    answer.bodies.push_back(std::move(body));
    return answer;
  }

  int modes_used() const override {
    return static_cast<int>(std::ranges::count_if(plan_.body.modes, [](const Roots& mode) { return mode.k > 0; }));
  }
  Index n_unknowns() const override { return (plan_.body.free ? 6 : 0) + plan_.body.n_modes() + plan_.body.n_static(); }

 private:
  // u in the body's axes becomes x - X, or is turned to the world's where the body is held.
  void place(const BodyState& state, Eigen::Ref<VectorXd> u) const {
    const Eigen::Matrix3d Q = state.Q.toRotationMatrix();
    auto at = u.reshaped(3, basis_->points.cols());
    if (plan_.body.free)
      at = (Q * (basis_->points + at.matrix())).colwise() + state.c - basis_->points;
    else
      at = (Q * at.matrix()).eval();
  }

  std::shared_ptr<const FloatingBasis> basis_;
  ImpactPlan plan_;
};

}  // namespace

void answer_in_contact(Reduction& reduction, const Model& model, const Modes& modes, bool static_contact) {
  if (model.scene->contacts.empty()) return;
  if (model.bodies.size() != 1) throw std::invalid_argument("modes in contact: one body alone");
  const auto basis = std::make_shared<const FloatingBasis>(floating_basis(model, modes, static_contact));
  reduction.in_contact = [basis](const Integrator& integrator, const Settings& settings) {
    return prepare_floating(basis, integrator, settings);
  };
}

std::unique_ptr<Prepared> prepare_floating(std::shared_ptr<const FloatingBasis> basis, const Integrator& integrator,
                                           const Settings& settings) {
  const auto scheme = contact_scheme(integrator.name);
  if (!scheme) throw std::invalid_argument("integrator '" + integrator.name + "' has no steps in contact for modes");
  return std::make_unique<PreparedFloating>(std::move(basis), *scheme, settings.time_step);
}

}  // namespace mb
