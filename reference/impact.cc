#include "reference/impact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "cases/contract/linear.h"
#include "reference/impact_history.h"
#include "reference/impact_limits.h"

namespace mb {

namespace {

constexpr double reach = 0.35;   // [-] of the body's extent: faces that much farther than the nearest never touch
constexpr double blown_up = 10;  // [-] energy by all that there was

class PreparedImpact final : public Prepared {
 public:
  PreparedImpact(const Model& model, const Integrator& integrator, const Settings& settings)
      : scene_(model.scene),
        body_(scene_->bodies.at(0)),
        points_(model.bodies.at(0).points.all()),
        displacement_{model.bodies[0].displacement, {}},
        strain_{model.bodies[0].strain, {}},
        full_(model.bodies[0].full),
        touchdown_(touchdown(*scene_, body_)),
        fall_(fall_of(*scene_, body_, std::min(touchdown_.t, scene_->duration))),
        system_(full_->system()),
        may_blow_up_(integrator.conditionally_stable) {
    if (!body_.twist.angular_velocity.isZero(0))
      throw std::invalid_argument(
          "body '" + body_.name +
          "' spins: full order of linear kinematics has small rotations only, of kinematics 'finite' any");
    if (!integrator.prepare_in_contact)
      throw std::invalid_argument("integrator '" + integrator.name + "' has no steps for full order in contact");
    if (fall_.free) system_.v0 = full_->translation(fall_.velocity + fall_.start * fall_.gravity);
    if (fall_.free && !(touchdown_.t < scene_->duration)) return;  // nothing is touched: closed form throughout
    for (const Meeting& meeting : touchdown_.meetings) contacts_.push_back(contact(meeting));
    stepper_ = integrator.prepare_in_contact(system_, contacts_, settings, scene_->duration - fall_.start);
  }

  Trajectory simulate(const Sampling& sampling) const override {
    if (sampling.shutter != 0) throw std::invalid_argument("no exact means in contact");
    const VectorXd& t = sampling.t;
    Index n_before = 0;
    while (n_before < t.size() && (t[n_before] < fall_.start || !stepper_)) ++n_before;
    Trajectory answer{t, {}, {}, Status::ok};
    States states;
    if (stepper_) states = stepper_->run(t.tail(t.size() - n_before).array() - fall_.start);
    answer.work = states.work;
    answer.status = states.status;
    if (stepper_ && sampling.reconstruct && answer.status == Status::ok && t.size() > n_before)
      answer.status = checked(states, t.tail(t.size() - n_before));
    BodyTrajectory body;
    body.contact = fall_.in_world(states.contact, n_before, t.size());
    if (sampling.reconstruct) {
      MatrixXd u = MatrixXd::Zero(system_.u0.size(), t.size());
      if (stepper_) u.rightCols(states.u.cols()) = states.u;
      body.displacement = fall_.placed(observe(displacement_, u, {}), points_, t);
      if (sampling.strain) {
        body.strain = observe(strain_, u, {});
        body.energy = energy(states, body.contact, n_before);
      }
    }
    answer.bodies.push_back(std::move(body));
    return answer;
  }

  Index n_unknowns() const override { return system_.u0.size(); }

 private:
  // What is not met first may be met by another side of the body, once that has been turned back: of a plane the part
  // that looks at it and comes first on any way there, of other obstacles all of the boundary.
  double reach_to(const Meeting& meeting, const RigidSurface& seen) const {
    const double usual = reach * extent(body_.shape);
    if (meeting.t <= fall_.start) return usual;
    if (!std::holds_alternative<HalfSpace>(seen.shape)) return std::numeric_limits<double>::infinity();
    double nearest = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < points_.cols(); ++i) nearest = std::min(nearest, gap_value(seen, points_.col(i)));
    return usual + std::max(0.0, nearest);
  }

  Contact contact(const Meeting& meeting) const {
    const ContactPair& pair = scene_->contacts[meeting.contact];
    const RigidSurface seen = seen_from(fall_.frame(), surface_met(*scene_, body_, meeting));
    const ContactSize& scale = size_for(touchdown_, meeting);
    return {full_->contact_points(seen, reach_to(meeting, seen)),
            seen,
            law_of(pair, meeting.size),
            {scale.approach, scale.speed},
            meeting.t <= fall_.start};
  }

  // Throws std::runtime_error for an answer beyond what is simulated here, with what came first. One that an explicit
  // scheme has blown up is no such answer: it has a status.
  Status checked(const States& states, const VectorXd& t) const {
    const MatrixXd rows = rotation_rows(system_, points_, observe(displacement_, system_.R, {}));
    std::optional<Fault> first = large_rotation(body_, rows, {t, states.u});
    for (size_t c = 0; c < contacts_.size(); ++c) {
      const ContactPair& pair = scene_->contacts[touchdown_.meetings[c].contact];
      const auto overlap = unwatched_overlap(body_, *full_, contacts_[c], pair.obstacle, {t, states.u});
      if (overlap && (!first || overlap->t < first->t)) first = overlap;
    }
    if (!first) return Status::ok;
    if (may_blow_up_ && has_blown_up(states)) return Status::unstable;
    throw std::runtime_error(first->what);
  }

  bool has_blown_up(const States& states) const {
    const VectorXd load = weight();
    const double there_was = kinetic_energy(system_, system_.v0) + load.lpNorm<1>() * extent(body_.shape);
    const auto u = states.u.rightCols(1), v = states.v.rightCols(1);
    return !(kinetic_energy(system_, v) + strain_energy(system_, u) - load.dot(u.col(0)) <= blown_up * there_was);
  }

  VectorXd weight() const {  // [N]
    return fall_.free ? VectorXd(system_.M * full_->translation(fall_.gravity)) : VectorXd(system_.F.rowwise().sum());
  }

  // The stepper's own; else of u and v at the times asked for.
  VectorXd energy(const States& states, const ContactHistory& contact, Index n_before) const {
    VectorXd E = VectorXd::Constant(contact.stored.size(), kinetic_energy(system_, full_system_velocity()));
    const VectorXd load = weight();
    const double mass =
        fall_.free ? full_->translation(Vector3d::UnitX()).dot(system_.M * full_->translation(Vector3d::UnitX())) : 0;
    const double fallen = -mass * fall_.gravity.dot(fall_.flown(fall_.start));
    if (states.energy.size() > 0) {
      E.tail(states.energy.size()) = states.energy.array() + fallen;
      return E;
    }
    for (Index k = 0; k < states.u.cols(); ++k)
      E[n_before + k] = kinetic_energy(system_, states.v.col(k)) + strain_energy(system_, states.u.col(k)) -
                        load.dot(states.u.col(k)) + fallen + contact.stored[n_before + k];
    return E;
  }
  // Before the first touch the energy is that at t = 0.
  VectorXd full_system_velocity() const { return full_->system().v0; }

  std::shared_ptr<const Scene> scene_;
  const Body& body_;
  Matrix3Xd points_;
  Observation displacement_, strain_;
  std::shared_ptr<const FullModel> full_;
  Touchdown touchdown_;
  Fall fall_;  // to the first touch, at most to the duration
  System system_;
  bool may_blow_up_;
  std::vector<Contact> contacts_;
  std::unique_ptr<Stepper> stepper_;  // none: nothing is touched
};

}  // namespace

std::unique_ptr<Prepared> prepare_impact(const Model& model, const Integrator& integrator, const Settings& settings) {
  if (model.bodies.size() != 1) throw std::invalid_argument("full order in contact: one body alone");
  return std::make_unique<PreparedImpact>(model, integrator, settings);
}

}  // namespace mb
