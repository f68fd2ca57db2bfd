#include "modal/contact/impact_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/contact/first_touch_support.h"
#include "modal/contact/body_flight.h"
#include "modal/contact/next_touch.h"
#include "modal/contact/soundness.h"

namespace mb {

namespace {

constexpr long max_steps = 20'000'000;
constexpr int look_every = 64;                          // steps
constexpr int least_patience = 2, most_patience = 1024; /* steps without touch before a body counts as flying */
constexpr double worthwhile = 32;                       // steps that a search for the next touch is worth

template <class T>
T mean(const T& a, const T& b, double x) {
  return (1 - x) * a + x * b;
}
// The cubic with both ends' values and rates, at fraction x of a step h.
template <class T>
T hermite(const T& a, const T& rate_a, const T& b, const T& rate_b, double h, double x) {
  return (1 + 2 * x) * (1 - x) * (1 - x) * a + x * (1 - x) * (1 - x) * h * rate_a + x * x * (3 - 2 * x) * b +
         x * x * (x - 1) * h * rate_b;
}

BodyState between(const BodyState& a, const BodyState& b, double h, double x) {
  return {.c = hermite<Vector3d>(a.c, a.v, b.c, b.v, h, x),
          .v = mean<Vector3d>(a.v, b.v, x),
          .Q = a.Q.slerp(x, b.Q),
          .L = mean<Vector3d>(a.L, b.L, x),
          .q = hermite<VectorXd>(a.q, a.p, b.q, b.p, h, x),
          .p = mean<VectorXd>(a.p, b.p, x),
          .s = mean<VectorXd>(a.s, b.s, x)};
}

class Run {
 public:
  Run(const ImpactPlan& plan, const VectorXd& times)
      : plan_(plan),
        times_(times),
        stepper_(plan.body, plan.scheme, plan.step),
        soundness_(plan.body, circumradius(plan.shape)) {
    const Index n_t = times.size();
    motion_.contact = {Matrix3Xd::Zero(3, n_t), Matrix3Xd::Zero(3, n_t), VectorXd::Zero(n_t), VectorXd::Zero(n_t), {}};
    motion_.energy = VectorXd::Zero(n_t);
    motion_.states.reserve(static_cast<size_t>(n_t));
  }

  ImpactMotion run() {
    const double end = times_.size() > 0 ? times_[times_.size() - 1] : 0;
    ContactState now{plan_.start, {}, Vector3d::Zero(), 0};
    double t = 0;
    if (!plan_.flies) touch_and_go(t, now, end);
    for (bool leaving = false; more() && motion_.status == Status::ok; leaving = true) {
      const BodyFlight flight(plan_.body, now.body, t);
      motion_.flights.push_back({t, now.body});
      const auto touch = next_touch(plan_, flight, end, leaving);
      const double until = touch ? touch->t : std::numeric_limits<double>::infinity();
      fly(flight, until, now);
      motion_.work.steps += flight.n_steps();
      if (flight.failed()) motion_.status = Status::no_convergence;
      if (!touch || flight.failed()) break;
      const bool worth = touch->decided && touch->t - t > worthwhile * plan_.step;
      patience_ = worth ? least_patience : std::min(2 * patience_, most_patience);
      t = touch->t;
      now.body = flight.at(t);
      motion_.work.load_evaluations += 1;
      t = touch_and_go(t, now, end);
    }
    motion_.contact.touches = log_.touches();
    motion_.work.load_evaluations += stepper_.n_evaluations();
    return std::move(motion_);
  }

 private:
  bool more() const { return static_cast<Index>(motion_.states.size()) < times_.size(); }
  double next_time() const { return times_[static_cast<Index>(motion_.states.size())]; }

  void record(BodyState body, const Vector3d& force, const ContactState& of, double stored, double energy) {
    const auto k = static_cast<Index>(motion_.states.size());
    motion_.contact.force.col(k) = force;
    motion_.contact.impulse.col(k) = of.impulse;
    motion_.contact.dissipated[k] = of.dissipated;
    motion_.contact.stored[k] = stored;
    motion_.energy[k] = energy;
    motion_.states.push_back(std::move(body));
  }

  void fly(const BodyFlight& flight, double end, const ContactState& since) {
    while (more() && next_time() < end) {
      BodyState body = flight.at(next_time());
      ++motion_.work.load_evaluations;
      const double energy = mechanical_energy(plan_.body, body);
      record(std::move(body), Vector3d::Zero(), since, 0, energy);
    }
    if (flight.failed()) motion_.states.resize(n_sound_);
    n_sound_ = motion_.states.size();
  }

  void note(double t, const ContactState& state) {
    log_.add({t, state.load.least_gap, state.load.force, state.impulse});
  }

  // Steps until the body lets go, if it flies then, or the end is reached; the time it is then.
  double touch_and_go(double start, ContactState& now, double end) {
    stepper_.touch(now);
    log_.meet(start);
    note(start, now);
    look_at(start, now);
    ContactState before;
    double t = start;
    int n_clear = 0, n_parting = 0, patience = patience_;  // steps in succession
    bool pressed = now.load.least_gap < 0;
    soundness_.begin(now);
    for (long i = 0; t < end; ++i) {
      before = now;
      if (!stepper_.advance(now) || motion_.work.steps == max_steps) {
        if (!sound(before)) return t;
        motion_.status = motion_.work.steps == max_steps ? Status::too_many_steps : Status::no_convergence;
        return t;
      }
      ++motion_.work.steps;
      const double t_before = t;
      t = start + static_cast<double>(i + 1) * plan_.step;
      note(t, now);
      look_between(t_before, before, now);
      // Apart and parting, seen twice: samples begin to press only a little after the surfaces meet.
      const bool clear = now.load.least_gap >= 0, parting = clear && !(now.load.least_gap < before.load.least_gap);
      n_clear = clear ? n_clear + 1 : 0;
      n_parting = parting ? n_parting + 1 : 0;
      pressed = pressed || !clear;
      if (i % look_every == 0 && !sound(now)) return t;
      if (!pressed) soundness_.begin(now);
      if (!plan_.flies || n_parting < least_patience || n_clear < patience) continue;
      if (!sound(now) || pressed || !comes_in(now.body, t)) return t;
      n_clear = 0;
      patience = std::min(2 * patience, most_patience);
    }
    sound(now);
    return t;
  }

  // States since the last look are given up where it finds the motion unsound.
  bool sound(const ContactState& now) {
    motion_.status = soundness_(now);
    if (motion_.status == Status::ok) n_sound_ = motion_.states.size();
    motion_.states.resize(n_sound_);
    return motion_.status == Status::ok;
  }

  // Whether the surface of a body of which no sample has pressed as yet goes on into an obstacle: it is one touch.
  bool comes_in(const BodyState& body, double t) const {
    return next_touch(plan_, BodyFlight(plan_.body, body, t), t + plan_.step, true).has_value();
  }

  // At the touch itself: a body may press from the start.
  void look_at(double t, const ContactState& now) {
    while (more() && next_time() <= t)
      record(now.body, now.load.force, now, now.load.stored, mechanical_energy(plan_.body, now.body) + now.load.stored);
  }

  void look_between(double t_before, const ContactState& a, const ContactState& b) {
    while (more() && next_time() <= t_before + plan_.step) {
      const double x = (next_time() - t_before) / plan_.step;
      ContactState of = a;
      of.impulse = mean<Vector3d>(a.impulse, b.impulse, x);
      of.dissipated = mean(a.dissipated, b.dissipated, x);
      const double energy_a = mechanical_energy(plan_.body, a.body) + a.load.stored,
                   energy_b = mechanical_energy(plan_.body, b.body) + b.load.stored;
      record(between(a.body, b.body, plan_.step, x), mean<Vector3d>(a.load.force, b.load.force, x), of,
             mean(a.load.stored, b.load.stored, x), mean(energy_a, energy_b, x));
    }
  }

  const ImpactPlan& plan_;
  const VectorXd& times_;
  ContactStepper stepper_;
  Soundness soundness_;
  size_t n_sound_ = 0;  // states
  TouchLog log_;
  ImpactMotion motion_;
  int patience_ = least_patience;  // doubled where flights turn out too short to be worth it: surfaces that chatter
};

}  // namespace

ImpactMotion impact_motion(const ImpactPlan& plan, const VectorXd& times) { return Run(plan, times).run(); }

}  // namespace mb
