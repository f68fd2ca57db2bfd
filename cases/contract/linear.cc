#include "cases/contract/linear.h"

#include <algorithm>

namespace mb {

MatrixXd observe(const Observation& observation, const MatrixXd& q, const MatrixXd& s) {
  MatrixXd values = std::visit([&](const auto& U) -> MatrixXd { return U * q; }, observation.of_state);
  if (observation.of_load.cols() > 0) values.noalias() += observation.of_load * s;
  return values;
}

namespace {

// Factors of the loads at the times t, loads x n_t.
MatrixXd load_factors(const std::vector<History>& histories, const VectorXd& t) {
  MatrixXd s(static_cast<Index>(histories.size()), t.size());
  for (Index l = 0; l < s.rows(); ++l)
    for (Index k = 0; k < t.size(); ++k) s(l, k) = value(histories[static_cast<size_t>(l)], t[k]);
  return s;
}

Work operator+(const Work& a, const Work& b) {
  return {a.steps + b.steps, a.rejected + b.rejected, a.factorisations + b.factorisations, a.solves + b.solves,
          a.load_evaluations + b.load_evaluations};
}

class PreparedLinear final : public Prepared {
 public:
  PreparedLinear(std::vector<LinearBody> bodies, const Integrator& integrator, const Settings& settings,
                 double duration, int modes_used)
      : bodies_(std::move(bodies)), modes_used_(modes_used) {
    for (const LinearBody& body : bodies_) steppers_.push_back(integrator.prepare(body.system, settings, duration));
  }

  Trajectory simulate(const Sampling& sampling) const override {
    Trajectory answer{sampling.t, {}, {}, Status::ok};
    for (size_t i = 0; i < bodies_.size(); ++i) {
      const LinearBody& body = bodies_[i];
      const States states = steppers_[i]->run(sampling.t);
      const MatrixXd s = load_factors(body.system.s, sampling.t);
      answer.bodies.push_back(
          {observe(body.displacement, states.u, s), sampling.strain ? observe(body.strain, states.u, s) : MatrixXd()});
      answer.work = answer.work + states.work;
      if (answer.status == Status::ok) answer.status = states.status;
    }
    return answer;
  }

  int modes_used() const override { return modes_used_; }
  Index n_unknowns() const override {
    Index n = 0;
    for (const auto& body : bodies_) n += body.system.u0.size();
    return n;
  }
  double load_error() const override {
    double largest = 0;
    for (const auto& stepper : steppers_) largest = std::max(largest, stepper->load_error());
    return largest;
  }

 private:
  std::vector<LinearBody> bodies_;  // before the steppers, which refer to its systems
  std::vector<std::unique_ptr<Stepper>> steppers_;
  int modes_used_;
};

}  // namespace

std::unique_ptr<Prepared> prepare_linear(std::vector<LinearBody> bodies, const Integrator& integrator,
                                         const Settings& settings, double duration, int modes_used) {
  return std::make_unique<PreparedLinear>(std::move(bodies), integrator, settings, duration, modes_used);
}

}  // namespace mb
