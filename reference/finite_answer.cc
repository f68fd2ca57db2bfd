#include "reference/finite_answer.h"

#include <algorithm>
#include <stdexcept>

#include "cases/contract/linear.h"
#include "mechanics/system/stored_energy.h"
#include "reference/impact_history.h"

namespace mb {

namespace {

// The body's start of flight, or where nothing can be touched, of its loads.
Touchdown touchdown_of(const Scene& scene, const Body& body) {
  return scene.contacts.empty() ? Touchdown{} : touchdown(scene, body);
}

class PreparedFinite final : public Prepared {
 public:
  PreparedFinite(const Model& model, const Integrator& integrator, const Settings& settings)
      : scene_(model.scene),
        body_(scene_->bodies.at(0)),
        points_(model.bodies.at(0).points.all()),
        displacement_{model.bodies[0].displacement, {}},
        strain_{model.bodies[0].strain, {}},
        full_(model.bodies[0].full),
        spins_(!is_held(body_) && !body_.twist.angular_velocity.isZero(0)),
        touchdown_(touchdown_of(*scene_, body_)),
        fall_(fall_of(*scene_, body_, start())),
        system_(full_->system()) {
    if (fall_.free) {
      X_ = full_->places();
      system_.v0 = start_velocity(0);
      energy_at_start_ = kinetic_energy(system_, system_.v0);
      system_.v0 = start_velocity(fall_.start);
    }
    if (scene_->contacts.empty()) {
      stepper_ = integrator.prepare(system_, settings, scene_->duration);
      return;
    }
    if (!integrator.prepare_in_contact)
      throw std::invalid_argument("integrator '" + integrator.name + "' has no steps for full order in contact");
    if (fall_.free && !spins_ && !(touchdown_.t < scene_->duration)) return;  // closed form throughout
    for (const Meeting& meeting : touchdown_.meetings) contacts_.push_back(contact(meeting));
    stepper_ = integrator.prepare_in_contact(system_, contacts_, settings, scene_->duration - fall_.start);
  }

  Trajectory simulate(const Sampling& sampling) const override {
    if (sampling.shutter != 0) throw std::invalid_argument("no exact means of a body of finite kinematics");
    const VectorXd& t = sampling.t;
    const Index n_before = stepper_ ? (t.array() < fall_.start).count() : t.size(), n_after = t.size() - n_before;
    Trajectory answer{t, {}, {}, Status::ok};
    States states;
    if (stepper_) states = stepper_->run(t.tail(n_after).array() - fall_.start);
    answer.work = states.work;
    answer.status = states.status;
    BodyTrajectory body;
    const bool touches = !scene_->contacts.empty();
    if (touches) body.contact = fall_.in_world(states.contact, n_before, t.size());
    if (sampling.reconstruct) {
      MatrixXd u = MatrixXd::Zero(system_.u0.size(), t.size());
      for (Index k = 0; k < std::min(n_after, states.n_valid); ++k) u.col(n_before + k) = states.u.col(k);
      const MatrixXd seen = observe(displacement_, u, {});
      body.displacement = touches ? fall_.placed(seen, points_, t) : seen;
      if (sampling.strain) {
        body.strain = observe(strain_, unturned(u), {});
        if (touches) body.energy = energy(states, body.contact, n_before);
      }
    }
    answer.bodies.push_back(std::move(body));
    return answer;
  }

  Index n_unknowns() const override { return system_.u0.size(); }

 private:
  double start() const {  // [s]
    return spins_ || scene_->contacts.empty() ? 0 : std::min(touchdown_.t, scene_->duration);
  }

  VectorXd start_velocity(double t) const {  // [m/s]
    VectorXd v = full_->translation(fall_.velocity + t * fall_.gravity);
    const Vector3d omega = body_.pose.orientation.conjugate() * body_.twist.angular_velocity;
    for (Index i = 0; spins_ && i < v.size(); i += 3) v.segment<3>(i) += omega.cross(Vector3d(X_.segment<3>(i)));
    return v;
  }

  Contact contact(const Meeting& meeting) const {
    const ContactSize& scale = size_for(touchdown_, meeting);
    return {full_->boundary(),
            seen_from(fall_.frame(), surface_met(*scene_, body_, meeting)),
            law_of(scene_->contacts[meeting.contact], meeting.size),
            {scale.approach, scale.speed},
            meeting.t <= fall_.start};
  }

  // Q^T (X + u) - X, whose small strain is that of the turning frame; of a body that is held u itself.
  MatrixXd unturned(const MatrixXd& u) const {
    if (!fall_.free) return u;
    const auto X = X_.reshaped(3, X_.size() / 3);
    MatrixXd seen(u.rows(), u.cols());
    for (Index k = 0; k < u.cols(); ++k) {
      const Eigen::Matrix3d Q = system_.stored_energy->rotation(u.col(k));
      const Matrix3Xd x = X + u.col(k).reshaped(3, X.cols());
      seen.col(k) = (Q.transpose() * x - X).reshaped();
    }
    return seen;
  }

  // The stepper's own; else of u and v at the times asked for.
  VectorXd energy(const States& states, const ContactHistory& contact, Index n_before) const {
    VectorXd E = VectorXd::Constant(contact.stored.size(), energy_at_start_);
    const VectorXd load = system_.F.rowwise().sum();
    const double mass = system_.M.sum() / 3, fallen = -mass * fall_.gravity.dot(fall_.flown(fall_.start));
    for (Index k = 0; k < states.n_valid; ++k)
      E[n_before + k] = states.energy.size() > 0
                            ? states.energy[k] + fallen
                            : kinetic_energy(system_, states.v.col(k)) + strain_energy(system_, states.u.col(k)) -
                                  load.dot(states.u.col(k)) + fallen + contact.stored[n_before + k];
    return E;
  }

  std::shared_ptr<const Scene> scene_;
  const Body& body_;
  Matrix3Xd points_;
  Observation displacement_, strain_;
  std::shared_ptr<const FullModel> full_;
  bool spins_;
  Touchdown touchdown_;
  Fall fall_;
  System system_;
  VectorXd X_;                  // [m] places of the unknowns of a free body
  double energy_at_start_ = 0;  // [J]
  std::vector<Contact> contacts_;
  std::unique_ptr<Stepper> stepper_;  // none: nothing is touched
};

}  // namespace

std::unique_ptr<Prepared> prepare_finite(const Model& model, const Integrator& integrator, const Settings& settings) {
  if (model.bodies.size() != 1) throw std::invalid_argument("full order of finite kinematics: one body alone");
  return std::make_unique<PreparedFinite>(model, integrator, settings);
}

}  // namespace mb
