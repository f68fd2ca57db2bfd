// Average acceleration with contact at the step's end, in the rates y = (v, Omega, p):
//
//   z1 = z0 + h/2 (y0 + y1),    M(Q1) y1 - M(Q0) y0 = h/2 (f0 + f1),    f = (F + m g, T, Phi^T F + weight - c p - l q)
#include <cmath>
#include <limits>

#include "modal/contact/contact_step.h"
#include "modal/frame/turn.h"

namespace mb {

namespace {

constexpr int max_iterations = 30;
constexpr double least_part = 1.0 / 128;  // [-] of Newton's step
constexpr double tolerance = 1e-10;       // [-] of the momenta in play: far below the error of any step
constexpr double near = 1e-7;  // [-] likewise, where Newton comes no nearer: in a stiff layer places are rounded

// One step of a body from `state`, whose load is known, on.
class NewmarkStep {
 public:
  NewmarkStep(const FloatingBody& body, const VectorXd& lambda, const VectorXd& c, double h, ContactState& state)
      : body_(body),
        lambda_(lambda),
        c_(c),
        h_(h),
        state_(state),
        start_(state),
        n_frame_(body.free ? 6 : 0),
        r_(body.n_modes()),
        y0_(n_frame_ + r_),
        mass_(n_frame_ + r_) {
    if (body.free) {
      y0_.head<6>() << start_.body.v, angular_velocity(body, start_.body);
      mass_.head<6>() << Vector3d::Constant(body.mass), body.inertia.diagonal();
    }
    y0_.tail(r_) = start_.body.p;
    mass_.tail(r_).setOnes();
    momentum0_ = momentum();
    f0_ = forces();
    pushed0_ = pushed();
  }

  const VectorXd& y0() const { return y0_; }

  // Puts the end of the step for rates y into the state, but for its load.
  void place(const VectorXd& y) {
    BodyState& b = state_.body;
    b.q = start_.body.q + h_ / 2 * (start_.body.p + y.tail(r_));
    b.p = y.tail(r_);
    if (!body_.free) return;
    b.c = start_.body.c + h_ / 2 * (start_.body.v + y.head<3>());
    b.v = y.head<3>();
    b.Q = turned(start_.body.Q, h_ / 2 * (y0_.segment<3>(3) + y.segment<3>(3)));
    b.L = b.Q * (body_.inertia * (b.Q.conjugate() * y.segment<3>(3)));
  }
  // Of momentum [kg m/s, kg m^2/s, kg^1/2 m/s], with the load of the state as it is.
  VectorXd imbalance() {
    f_ = forces();
    return momentum() - momentum0_ - h_ / 2 * (f0_ + f_);
  }
  double size(const VectorXd& x) const {
    return std::isfinite(x.sum()) ? std::sqrt((x.array().square() / mass_.array()).sum())
                                  : std::numeric_limits<double>::infinity();
  }
  // Likewise of the momentum of rates [m/s, 1/s, m kg^1/2 / s].
  double size_of_rates(const VectorXd& y) const { return std::sqrt((y.array().square() * mass_.array()).sum()); }
  // Of the momenta in play.
  double scale() const { return size(momentum0_) + h_ * (pushed0_ + pushed()); }
  Index n() const { return y0_.size(); }

  // d imbalance / dy without contact, added to the block.
  void add_jacobian(Eigen::Ref<MatrixXd> block) const {
    block.diagonal().tail(r_).array() += 1 + h_ / 2 * c_.array() + h_ * h_ / 4 * lambda_.array();
    if (!body_.free) return;
    const Eigen::Matrix3d Q = state_.body.Q.toRotationMatrix();
    block.diagonal().head<3>().array() += body_.mass;
    block.block<3, 3>(3, 3) += Q * body_.inertia * Q.transpose();
  }
  // Momenta from the forces themselves: handed over to rounding, not to the tolerance.
  void hand_over() {
    if (body_.free) {
      state_.body.v = start_.body.v + h_ / (2 * body_.mass) * (f0_.head<3>() + f_.head<3>());
      state_.body.L = start_.body.L + h_ / 2 * (f0_.segment<3>(3) + f_.segment<3>(3));
    }
    state_.impulse = start_.impulse + h_ / 2 * (start_.load.force + state_.load.force);
    state_.dissipated = start_.dissipated + h_ / 2 * (start_.load.dissipation + state_.load.dissipation);
  }

 private:
  VectorXd momentum() const {
    VectorXd all(n_frame_ + r_);
    if (body_.free) all.head<6>() << body_.mass * state_.body.v, state_.body.L;
    all.tail(r_) = state_.body.p;
    return all;
  }
  VectorXd forces() const {
    VectorXd all(n_frame_ + r_);
    if (body_.free) all.head<6>() << state_.load.force + body_.mass * body_.gravity, state_.load.torque;
    all.tail(r_) =
        state_.load.modal + body_.weight - c_.cwiseProduct(state_.body.p) - lambda_.cwiseProduct(state_.body.q);
    return all;
  }
  // The size of the parts of the forces: at rest they balance, and nothing is left of them to measure by.
  double pushed() const {
    const BodyState& b = state_.body;
    VectorXd all(n_frame_ + r_);
    if (body_.free)
      all.head<6>() << state_.load.force.cwiseAbs() + body_.mass * body_.gravity.cwiseAbs(), state_.load.torque;
    all.tail(r_) = state_.load.modal.cwiseAbs() + body_.weight.cwiseAbs() + c_.cwiseProduct(b.p.cwiseAbs()) +
                   lambda_.cwiseProduct(b.q.cwiseAbs());
    return size(all);
  }

  const FloatingBody& body_;
  const VectorXd &lambda_, &c_;
  double h_;
  ContactState& state_;
  const ContactState start_;
  Index n_frame_, r_;
  VectorXd y0_, mass_, momentum0_, f0_, f_;
  double pushed0_;
};

}  // namespace

namespace {

// All bodies: their rates y below each other.
class NewmarkSteps {
 public:
  explicit NewmarkSteps(std::vector<NewmarkStep> steps) : steps_(std::move(steps)) {
    for (const NewmarkStep& step : steps_) n_ += step.n();
  }
  VectorXd y0() {
    return gathered([](const NewmarkStep& step) { return step.y0(); });
  }
  void place(const VectorXd& y) {
    each(y, [](NewmarkStep& step, const auto& own) { step.place(own); });
  }
  VectorXd imbalance() {
    return gathered([](NewmarkStep& step) { return step.imbalance(); });
  }
  double size(const VectorXd& x) {
    double sum = 0;
    each(x, [&](NewmarkStep& step, const auto& own) { sum = std::hypot(sum, step.size(own)); });
    return sum;
  }
  bool balanced(const VectorXd& residual) { return is_small(size(residual), tolerance); }
  // By what is left and by Newton's own change of the rates.
  bool is_near(const VectorXd& residual, const VectorXd& change) {
    double sum = 0;
    each(change, [&](NewmarkStep& step, const auto& own) { sum = std::hypot(sum, step.size_of_rates(own)); });
    return is_small(size(residual), near) && is_small(sum, near);
  }
  VectorXd newton_step(const VectorXd& residual, MatrixXd jacobian) {
    Index first = 0;
    for (const NewmarkStep& step : steps_) {
      step.add_jacobian(jacobian.block(first, first, step.n(), step.n()));
      first += step.n();
    }
    return jacobian.partialPivLu().solve(residual);
  }
  void hand_over() {
    for (NewmarkStep& step : steps_) step.hand_over();
  }

 private:
  // Momentum, against those in play.
  bool is_small(double off, double share) const {
    double scale = 0;
    for (const NewmarkStep& step : steps_) scale += step.scale();
    return std::isfinite(off) && off <= share * scale;
  }
  template <class Part>
  void each(const VectorXd& all, const Part& part) {
    Index first = 0;
    for (NewmarkStep& step : steps_) {
      part(step, VectorXd(all.segment(first, step.n())));
      first += step.n();
    }
  }
  template <class Part>
  VectorXd gathered(const Part& part) {
    VectorXd all(n_);
    Index first = 0;
    for (NewmarkStep& step : steps_) {
      all.segment(first, step.n()) = part(step);
      first += step.n();
    }
    return all;
  }

  std::vector<NewmarkStep> steps_;
  Index n_ = 0;
};

}  // namespace

bool ContactStepper::advance_by_newmark(std::span<ContactState> states) {
  std::vector<NewmarkStep> each;
  for (size_t b = 0; b < states.size(); ++b)
    each.emplace_back(*bodies_[b].body, bodies_[b].lambda, bodies_[b].c, h_, states[b]);
  NewmarkSteps step(std::move(each));
  const auto imbalance = [&](const VectorXd& y) {
    step.place(y);
    look(states);
    return step.imbalance();
  };
  VectorXd y = step.y0(), residual = imbalance(y);
  for (int i = 0; !step.balanced(residual); ++i) {
    const double before = step.size(residual);
    if (i == max_iterations || !std::isfinite(before) || !converged(states)) return false;
    const VectorXd change = step.newton_step(residual, h_ * h_ / 4 * loads_.stiffness(static_shapes(states), 2 / h_));
    double part = 1;
    for (residual = imbalance(y - change); !(step.size(residual) < before) && part > least_part;) {
      part /= 2;
      residual = imbalance(y - part * change);
    }
    y -= part * change;
    const double after = step.size(residual);
    if (!(after < before / 2) && step.is_near(residual, change)) break;
  }
  step.hand_over();
  return converged(states);
}

}  // namespace mb
