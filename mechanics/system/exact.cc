#include "mechanics/system/exact.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "mechanics/geometry/overloaded.h"
#include "mechanics/system/complex_modes.h"
#include "mechanics/system/modal_form.h"
#include "mechanics/system/modal_motion.h"
#include "mechanics/system/stored_energy.h"

namespace mb {
namespace {

constexpr double rounding = 1e-12;  // t = n dt may exceed the duration by an ulp

// Uncoupled modes, or what damping couples.
struct Motion {
  std::variant<ModalMotion, CoupledMotion> of;
  ModalStates states(const VectorXd& times) const {
    return std::visit(overloaded{[&](const ModalMotion& m) { return mb::states(m, times); },
                                 [&](const CoupledMotion& m) { return m.states(times); }},
                      of);
  }
  ModalStates means(const VectorXd& times, double width) const {
    return std::visit(overloaded{[&](const ModalMotion& m) { return mb::means(m, times, width); },
                                 [&](const CoupledMotion& m) { return m.means(times, width); }},
                      of);
  }
};

class Exact final : public Stepper {
 public:
  // Phi: 0 x 0 for the identity
  Exact(Motion motion, MatrixXd Phi, double duration, double load_error)
      : motion_(std::move(motion)), Phi_(std::move(Phi)), duration_(duration), load_error_(load_error) {}

  States run(const VectorXd& times) const override {
    check_times(times);
    return physical(motion_.states(times));
  }

  States averages(const VectorXd& times, double width) const override {
    check_times(times);
    if (!(width > 0 && std::isfinite(width))) throw std::invalid_argument("the width of a mean must be positive");
    if (times.size() > 0 && !(times[times.size() - 1] + width / 2 <= duration_ * (1 + rounding)))
      throw std::invalid_argument("a mean reaches beyond the duration");
    return physical(motion_.means(times, width));
  }

  double load_error() const override { return load_error_; }

 private:
  void check_times(const VectorXd& times) const {
    for (Index j = 0; j < times.size(); ++j) {
      const double before = j > 0 ? times[j - 1] : 0;
      if (!(times[j] >= before && times[j] <= duration_ * (1 + rounding)))
        throw std::invalid_argument("times must ascend from 0 to the duration");
    }
  }

  States physical(ModalStates modal) const {
    const Index n_times = modal.q.cols();
    States states;
    states.u = Phi_.size() > 0 ? MatrixXd(Phi_ * modal.q) : std::move(modal.q);
    states.v = Phi_.size() > 0 ? MatrixXd(Phi_ * modal.v) : std::move(modal.v);
    states.work = modal.work;
    while (states.n_valid < n_times && states.u.col(states.n_valid).allFinite() &&
           states.v.col(states.n_valid).allFinite())
      ++states.n_valid;
    if (states.n_valid < n_times) states.status = Status::not_finite;
    blank_rest(states);
    return states;
  }

  Motion motion_;
  MatrixXd Phi_;
  double duration_, load_error_;
};

Motion motion(const System& system, const ModalForm& form, std::vector<Piece> pieces) {
  const bool identity = form.Phi.size() == 0;
  const MatrixXd f = identity ? system.F : MatrixXd(form.Phi.transpose() * system.F);
  const VectorXd q0 = identity ? system.u0 : VectorXd(form.Phi.transpose() * (system.M * system.u0));
  const VectorXd v0 = identity ? system.v0 : VectorXd(form.Phi.transpose() * (system.M * system.v0));
  if (form.C.size() > 0) return {CoupledMotion(form.lambda.cwiseSqrt(), form.C, f, q0, v0, std::move(pieces))};
  ModalMotion uncoupled{{}, f, q0, v0, std::move(pieces)};
  for (Index i = 0; i < form.lambda.size(); ++i) uncoupled.modes.push_back(roots({form.lambda[i], form.c[i]}));
  return {std::move(uncoupled)};
}

}  // namespace

std::unique_ptr<Stepper> exact(const System& system, double duration, double load_tolerance) {
  require_linear(system, "exact");
  auto form = modal_form(system);
  std::vector<Segments> chains;
  double load_error = 0;
  for (const auto& history : system.s) {
    chains.push_back(segments(history, duration, load_tolerance));
    load_error = std::max(load_error, chains.back().load_error);
  }
  if (!(duration > 0 && std::isfinite(duration))) throw std::invalid_argument("the duration must be positive");

  return std::make_unique<Exact>(motion(system, form, merged(chains, duration)), std::move(form.Phi), duration,
                                 load_error);
}

}  // namespace mb
