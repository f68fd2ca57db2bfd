#include "cases/contract/linear.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "mechanics/history/mean.h"

namespace mb {

namespace {

MatrixXd product(const MatrixXd& U, const MatrixXd& q) { return U * q; }
// Some times at once, side by side: U is read once for all of them, and what it scatters to stays in the cache.
MatrixXd product(const SparseMatrix& U, const MatrixXd& q) {
  constexpr int at_once = 16;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, at_once, Eigen::RowMajor>;
  MatrixXd values(U.rows(), q.cols());
  Rows some = Rows::Zero(q.rows(), at_once), seen(U.rows(), at_once);
  for (Index from = 0; from < q.cols(); from += at_once) {
    const Index n = std::min<Index>(at_once, q.cols() - from);
    some.leftCols(n) = q.middleCols(from, n);
    seen.setZero();
    for (Index j = 0; j < U.cols(); ++j)
      for (SparseMatrix::InnerIterator u(U, j); u; ++u) seen.row(u.index()) += u.value() * some.row(j);
    values.middleCols(from, n) = seen.leftCols(n);
  }
  return values;
}

}  // namespace

MatrixXd observe(const Observation& observation, const MatrixXd& q, const MatrixXd& s) {
  MatrixXd values = std::visit([&](const auto& U) { return product(U, q); }, observation.of_state);
  if (observation.of_load.cols() > 0) values.noalias() += observation.of_load * s;
  return values;
}

namespace {

// The loads of one body, ready to be read off at times or as means, these from the pieces that the closed form moves
// the modes with.
class LoadSignals {
 public:
  LoadSignals(const std::vector<History>& histories, double duration, double tolerance) {
    for (const History& history : histories) {
      values_.push_back(evaluator(history));
      chains_.push_back(segments(history, duration, tolerance));
    }
  }

  // loads x n_t
  MatrixXd at(const Sampling& sampling) const {
    const VectorXd& t = sampling.t;
    const double half = sampling.shutter / 2;
    MatrixXd s(static_cast<Index>(values_.size()), t.size());
    for (Index l = 0; l < s.rows(); ++l) {
      const auto i = static_cast<size_t>(l);
      for (Index k = 0; k < t.size(); ++k)
        s(l, k) = half > 0 ? mean(chains_[i], t[k] - half, t[k] + half) : values_[i](t[k]);
    }
    return s;
  }

 private:
  std::vector<std::function<double(double)>> values_;
  std::vector<Segments> chains_;
};

bool is_corrected(const LinearBody& body) {
  return body.displacement.of_load.cols() > 0 || body.strain.of_load.cols() > 0;
}

class PreparedLinear final : public Prepared {
 public:
  PreparedLinear(std::shared_ptr<const Reduction> reduction, const Integrator& integrator, const Settings& settings,
                 double duration)
      : reduction_(std::move(reduction)) {
    for (const LinearBody& body : reduction_->bodies) {
      steppers_.push_back(integrator.prepare(body.system, settings, duration));
      const std::vector<History> seen = is_corrected(body) ? body.system.s : std::vector<History>();
      loads_.emplace_back(seen, duration, settings.load_tolerance);
    }
  }

  Trajectory simulate(const Sampling& sampling) const override {
    if (!(sampling.shutter >= 0)) throw std::invalid_argument("the shutter must not be negative");
    Trajectory answer{sampling.t, {}, {}, Status::ok};
    for (size_t i = 0; i < steppers_.size(); ++i) {
      const Stepper& stepper = *steppers_[i];
      const States states =
          sampling.shutter > 0 ? stepper.averages(sampling.t, sampling.shutter) : stepper.run(sampling.t);
      answer.work = answer.work + states.work;
      if (answer.status == Status::ok) answer.status = states.status;
      if (sampling.reconstruct)
        answer.bodies.push_back(reconstruct(reduction_->bodies[i], loads_[i], states.u, sampling));
    }
    return answer;
  }

  int modes_used() const override { return reduction_->modes_used; }
  Index n_unknowns() const override {
    Index n = 0;
    for (const auto& body : reduction_->bodies) n += body.system.u0.size();
    return n;
  }
  double load_error() const override {
    double largest = 0;
    for (const auto& stepper : steppers_) largest = std::max(largest, stepper->load_error());
    return largest;
  }

 private:
  static BodyTrajectory reconstruct(const LinearBody& body, const LoadSignals& loads, const MatrixXd& q,
                                    const Sampling& sampling) {
    const MatrixXd s = is_corrected(body) ? loads.at(sampling) : MatrixXd();
    return {observe(body.displacement, q, s), sampling.strain ? observe(body.strain, q, s) : MatrixXd()};
  }

  std::shared_ptr<const Reduction> reduction_;  // steppers refer to its systems
  std::vector<std::unique_ptr<Stepper>> steppers_;
  std::vector<LoadSignals> loads_;  // without any where a body needs none
};

}  // namespace

Reduction unreduced(const Model& model) {
  Reduction reduction{{}, -1};
  for (const BodyModel& body : model.bodies)
    reduction.bodies.push_back({body.full->system(), {body.displacement, {}}, {body.strain, {}}});
  if (!model.scene->contacts.empty())
    reduction.in_contact = [](const Integrator&, const Settings&) -> std::unique_ptr<Prepared> {
      throw std::invalid_argument("a linear system alone: contact is not simulated");
    };
  return reduction;
}

std::unique_ptr<Prepared> prepare_linear(std::shared_ptr<const Reduction> reduction, const Integrator& integrator,
                                         const Settings& settings, double duration) {
  if (reduction->in_contact) return reduction->in_contact(integrator, settings);
  return std::make_unique<PreparedLinear>(std::move(reduction), integrator, settings, duration);
}

std::unique_ptr<Prepared> prepare_linear(std::vector<LinearBody> bodies, const Integrator& integrator,
                                         const Settings& settings, double duration, int modes_used) {
  return prepare_linear(std::make_shared<const Reduction>(std::move(bodies), modes_used), integrator, settings,
                        duration);
}

std::unique_ptr<Prepared> LinearMethod::prepare(const Model& model, const Settings& settings,
                                                const Integrator& integrator) const {
  return prepare_linear(std::make_shared<const Reduction>(reduce(model, settings)), integrator, settings,
                        model.scene->duration);
}

}  // namespace mb
