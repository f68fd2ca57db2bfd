#include "reference/finite_answer.h"

#include <algorithm>
#include <stdexcept>

#include "reference/impact_member.h"

namespace mb {

namespace {

class PreparedFinite final : public Prepared {
 public:
  PreparedFinite(const Model& model, const Integrator& integrator, const Settings& settings)
      : scene_(model.scene), displacement_{model.bodies[0].displacement, {}}, body_(model, 0) {
    body_.start_at(0, integrator, settings);
    stepper_ = integrator.prepare(body_.system(), settings, scene_->duration);
  }

  Trajectory simulate(const Sampling& sampling) const override {
    if (sampling.shutter != 0) throw std::invalid_argument("no exact means of a body of finite kinematics");
    const States states = stepper_->run(sampling.t);
    Trajectory answer{sampling.t, {}, states.work, states.status};
    BodyTrajectory body;
    if (sampling.reconstruct) {
      MatrixXd u = states.u;
      u.rightCols(u.cols() - states.n_valid).setZero();
      body.displacement = observe(displacement_, u, {});
      if (sampling.strain) {
        body.strain = body_.strain(u);
        body.energy = energy(states);
      }
    }
    answer.bodies.push_back(std::move(body));
    return answer;
  }

  Index n_unknowns() const override { return body_.n(); }

 private:
  // [J] Kinetic and stored, by the mass that is stepped; 0 where nothing was reached.
  VectorXd energy(const States& states) const {
    VectorXd E = VectorXd::Zero(states.u.cols());
    for (Index k = 0; k < states.n_valid; ++k)
      E[k] = body_.kinetic_energy(states.v.col(k)) + strain_energy(body_.system(), states.u.col(k));
    return E;
  }

  std::shared_ptr<const Scene> scene_;
  Observation displacement_;
  ImpactMember body_;
  std::unique_ptr<Stepper> stepper_;
};

}  // namespace

std::unique_ptr<Prepared> prepare_finite(const Model& model, const Integrator& integrator, const Settings& settings) {
  if (model.bodies.size() != 1) throw std::invalid_argument("full order of finite kinematics: one body alone");
  return std::make_unique<PreparedFinite>(model, integrator, settings);
}

}  // namespace mb
