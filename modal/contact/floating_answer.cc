#include "modal/contact/floating_answer.h"

#include <algorithm>
#include <stdexcept>

#include "cases/contract/physical_shift.h"
#include "modal/frame/frame_loads.h"
#include "modal/frame/spin.h"

namespace mb {

std::vector<ImpactPlan> impact_plans(const FloatingBases& bases, ContactScheme scheme, double step,
                                     RotationCoupling rotation) {
  std::vector<ImpactPlan> plans;
  for (const FloatingBasis& basis : bases) {
    const Body& body = basis.scene->bodies[basis.place];
    plans.push_back({basis.body, body.shape, basis.geometry.basis, basis.bounds, basis.start, scheme, step,
                     body.theory == Theory::solid});
    if (rotation == RotationCoupling::rigid || !basis.body.free || basis.body.n_modes() == 0) continue;
    plans.back().body.coupling = std::make_shared<const SpinCoupling>(
        spin_coupling(*basis.full, basis.Phi, rotation == RotationCoupling::coupled, physical_shift(body)));
  }
  return plans;
}

namespace {

// u in the body's axes becomes x - X, or is turned to the world's where the body is held.
void place(const FloatingBasis& basis, const BodyState& state, Eigen::Ref<VectorXd> u) {
  const Eigen::Matrix3d Q = state.Q.toRotationMatrix();
  Eigen::Map<Matrix3Xd> at(u.data(), 3, basis.points.cols());
  for (Index i = 0; i < at.cols(); ++i) {  // point by point: nothing is allocated
    const Vector3d X = basis.points.col(i), own = at.col(i);
    at.col(i) = basis.body.free ? Vector3d(Q * (X + own) + state.c - X) : Vector3d(Q * own);
  }
}

// The frame's alone: deformation carries none.
MatrixXd momentum(const FloatingBody& body, const ImpactMotion& motion, const VectorXd& t) {
  MatrixXd all = MatrixXd::Zero(6, t.size());
  for (size_t k = 0; k < motion.states.size(); ++k) {
    const auto& [c, v, Q, L, q, p, s] = motion.states[k];
    const auto column = static_cast<Index>(k);
    const Vector3d P = body.mass * v;
    all.col(column) << P - t[column] * body.mass * body.gravity, c.cross(P) + L;
  }
  return all;
}

BodyTrajectory observed(const FloatingBasis& basis, const ImpactMotion& motion, const Sampling& sampling) {
  const Index n_t = sampling.t.size(), r = basis.body.n_modes(), n_s = basis.body.n_static();
  BodyTrajectory body;
  const FrameLoads* const loads = basis.body.loads.get();
  if (!loads) body.contact = motion.contact;
  if (!sampling.reconstruct) return body;
  MatrixXd a(basis.load_displacement.cols(), n_t);  // of loads' patterns
  for (Index k = 0; loads && a.rows() > 0 && k < std::ssize(motion.states); ++k)
    a.col(k) = loads->amplitudes(sampling.t[k], sampling.t[k], motion.states[static_cast<size_t>(k)].Q);
  MatrixXd q = MatrixXd::Zero(r, n_t), s = MatrixXd::Zero(n_s, n_t);
  for (size_t k = 0; k < motion.states.size(); ++k) {
    q.col(static_cast<Index>(k)) = motion.states[k].q;
    s.col(static_cast<Index>(k)) = motion.states[k].s;
  }
  body.displacement.noalias() = basis.displacement * q;
  if (n_s > 0) body.displacement.noalias() += basis.static_displacement * s;
  if (a.rows() > 0) body.displacement.noalias() += basis.load_displacement * a;
  for (size_t k = 0; k < motion.states.size(); ++k)
    place(basis, motion.states[k], body.displacement.col(static_cast<Index>(k)));
  if (!sampling.strain) return body;
  body.strain = basis.strain * q;
  if (n_s > 0) body.strain.noalias() += basis.static_strain * s;
  if (a.rows() > 0) body.strain.noalias() += basis.load_strain * a;
  if (loads) return body;
  body.energy = motion.energy;
  if (basis.body.free) body.momentum = momentum(basis.body, motion, sampling.t);
  return body;
}

class PreparedFloating final : public Prepared {
 public:
  PreparedFloating(std::shared_ptr<const FloatingBases> bases, ContactScheme scheme, const Settings& settings)
      : bases_(std::move(bases)), plans_(impact_plans(*bases_, scheme, step_of(settings), settings.rotation)) {}

  Trajectory simulate(const Sampling& sampling) const override {
    if (sampling.shutter != 0) throw std::invalid_argument("no exact means in contact");
    const std::vector<ImpactMotion> motions = impact_motions(plans_, sampling.t);
    Trajectory answer{sampling.t, {}, motions.front().work, motions.front().status};
    for (size_t b = 0; b < motions.size(); ++b) answer.bodies.push_back(observed((*bases_)[b], motions[b], sampling));
    return answer;
  }

  // Of the body that uses most.
  int modes_used() const override {
    Index most = 0;
    for (const ImpactPlan& plan : plans_)
      most = std::max(most, std::ranges::count_if(plan.body.modes, [](const Roots& mode) { return mode.k > 0; }));
    return static_cast<int>(most);
  }
  Index n_unknowns() const override {
    Index n = 0;
    for (const ImpactPlan& plan : plans_) n += (plan.body.free ? 6 : 0) + plan.body.n_modes() + plan.body.n_static();
    return n;
  }

 private:
  // Without contact no step is taken, and none is stated.
  double step_of(const Settings& settings) const {
    return bases_->front().body.loads ? bases_->front().scene->duration : settings.time_step;
  }

  std::shared_ptr<const FloatingBases> bases_;
  std::vector<ImpactPlan> plans_;
};

}  // namespace

void answer_in_frames(Reduction& reduction, const Model& model, std::span<const Modes> modes, bool corrected) {
  if (model.scene->contacts.empty() && !turn_freely(*model.scene)) return;
  const auto bases = std::make_shared<const FloatingBases>(floating_bases(model, modes, corrected));
  reduction.in_contact = [bases](const Integrator& integrator, const Settings& settings) {
    return prepare_floating(bases, integrator, settings);
  };
}

std::unique_ptr<Prepared> prepare_floating(std::shared_ptr<const FloatingBases> bases, const Integrator& integrator,
                                           const Settings& settings) {
  const auto scheme = contact_scheme(integrator.name);
  if (!scheme) throw std::invalid_argument("integrator '" + integrator.name + "' has no steps in contact for modes");
  if (bases->front().body.loads && *scheme != ContactScheme::exact)
    throw std::invalid_argument("modes of a body that turns: loads move it to a tolerance, integrator 'exact' alone");
  return std::make_unique<PreparedFloating>(std::move(bases), *scheme, settings);
}

}  // namespace mb
