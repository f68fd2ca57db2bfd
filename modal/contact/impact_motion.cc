#include "modal/contact/impact_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/contact/first_touch_support.h"
#include "modal/contact/meetings.h"
#include "modal/contact/soundness.h"
#include "modal/frame/body_flight.h"

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

BodyState between(const FloatingBody& body, const BodyState& a, const BodyState& b, double h, double x) {
  return {.c = hermite<Vector3d>(a.c, a.v, b.c, b.v, h, x),
          .v = mean<Vector3d>(a.v, b.v, x),
          .Q = a.Q.slerp(x, b.Q),
          .L = mean<Vector3d>(a.L, b.L, x),
          .q = hermite<VectorXd>(a.q, rates(body, a), b.q, rates(body, b), h, x),
          .p = mean<VectorXd>(a.p, b.p, x),
          .s = mean<VectorXd>(a.s, b.s, x)};
}

std::vector<const FloatingBody*> bodies_of(std::span<const ImpactPlan> plans) {
  std::vector<const FloatingBody*> all;
  for (const ImpactPlan& plan : plans) all.push_back(&plan.body);
  return all;
}
std::vector<double> sizes_of(std::span<const ImpactPlan> plans) {
  std::vector<double> all;
  for (const ImpactPlan& plan : plans) all.push_back(circumradius(plan.shape));
  return all;
}

class Run {
 public:
  Run(std::span<const ImpactPlan> plans, const VectorXd& times)
      : plans_(plans),
        step_(plans.front().step),
        times_(times),
        stepper_(bodies_of(plans), plans.front().scheme, step_),
        soundness_(bodies_of(plans), sizes_of(plans)),
        meetings_(plans),
        logs_(plans.size()),
        motions_(plans.size()) {
    const Index n_t = times.size();
    for (ImpactMotion& motion : motions_) {
      motion.contact = {Matrix3Xd::Zero(3, n_t), Matrix3Xd::Zero(3, n_t), VectorXd::Zero(n_t), VectorXd::Zero(n_t), {}};
      motion.energy = VectorXd::Zero(n_t);
      motion.states.reserve(static_cast<size_t>(n_t));
    }
    flies_ = std::ranges::all_of(plans, &ImpactPlan::flies);
  }

  std::vector<ImpactMotion> run() {
    const double end = times_.size() > 0 ? times_[times_.size() - 1] : 0;
    std::vector<ContactState> now;
    for (const ImpactPlan& plan : plans_) now.push_back({plan.start, {}, Vector3d::Zero(), 0});
    double t = 0;
    if (!flies_) touch_and_go(t, now, end);
    for (bool leaving = false; more() && status_ == Status::ok; leaving = true) {
      std::vector<BodyFlight> flights;
      for (size_t b = 0; b < plans_.size(); ++b) {
        flights.emplace_back(plans_[b].body, now[b].body, t);
        motions_[b].flights.push_back({t, now[b].body});
      }
      const auto touch = meetings_.next(flights, end, leaving);
      fly(flights, touch ? touch->t : std::numeric_limits<double>::infinity(), now);
      for (const BodyFlight& flight : flights) {
        work_.steps += flight.n_steps();
        if (flight.failed()) status_ = Status::no_convergence;
      }
      if (!touch || status_ != Status::ok) break;
      const bool worth = touch->decided && touch->t - t > worthwhile * step_;
      patience_ = worth ? least_patience : std::min(2 * patience_, most_patience);
      t = touch->t;
      for (size_t b = 0; b < now.size(); ++b) now[b].body = flights[b].at(t);
      work_.load_evaluations += 1;
      t = touch_and_go(t, now, end);
    }
    work_.load_evaluations += stepper_.n_evaluations();
    for (size_t b = 0; b < motions_.size(); ++b) {
      motions_[b].contact.touches = logs_[b].touches();
      motions_[b].status = status_;
    }
    motions_.front().work = work_;
    return std::move(motions_);
  }

 private:
  bool more() const { return static_cast<Index>(motions_.front().states.size()) < times_.size(); }
  double next_time() const { return times_[static_cast<Index>(motions_.front().states.size())]; }

  static void record(ImpactMotion& motion, BodyState body, const Vector3d& force, const ContactState& of, double stored,
                     double energy) {
    const auto k = static_cast<Index>(motion.states.size());
    motion.contact.force.col(k) = force;
    motion.contact.impulse.col(k) = of.impulse;
    motion.contact.dissipated[k] = of.dissipated;
    motion.contact.stored[k] = stored;
    motion.energy[k] = energy;
    motion.states.push_back(std::move(body));
  }
  // States from the n-th on are given up.
  void keep(size_t n) {
    for (ImpactMotion& motion : motions_) motion.states.resize(n);
  }
  size_t n_states() const { return motions_.front().states.size(); }

  void fly(const std::vector<BodyFlight>& flights, double end, const std::vector<ContactState>& since) {
    while (more() && next_time() < end) {
      ++work_.load_evaluations;
      const double t = next_time();
      for (size_t b = 0; b < flights.size(); ++b) {
        BodyState body = flights[b].at(t);
        const double energy = mechanical_energy(plans_[b].body, body);
        record(motions_[b], std::move(body), Vector3d::Zero(), since[b], 0, energy);
      }
    }
    if (std::ranges::any_of(flights, &BodyFlight::failed)) keep(n_sound_);
    n_sound_ = n_states();
  }

  void note(double t, const std::vector<ContactState>& states) {
    for (size_t b = 0; b < states.size(); ++b)
      logs_[b].add({t, states[b].load.least_gap, states[b].load.force, states[b].impulse});
  }

  static double least_gap(const std::vector<ContactState>& states) {
    double least = std::numeric_limits<double>::infinity();
    for (const ContactState& state : states) least = std::min(least, state.load.least_gap);
    return least;
  }

  // Steps until the bodies let go, if they fly then, or the end is reached; the time it is then.
  double touch_and_go(double start, std::vector<ContactState>& now, double end) {
    stepper_.touch(now);
    for (TouchLog& log : logs_) log.meet(start);
    note(start, now);
    look_at(start, now);
    std::vector<ContactState> before;
    double t = start;
    int n_clear = 0, n_parting = 0, patience = patience_;  // steps in succession
    bool pressed = least_gap(now) < 0;
    soundness_.begin(now);
    for (long i = 0; t < end; ++i) {
      before = now;
      if (!stepper_.advance(now) || work_.steps == max_steps) {
        if (!sound(before)) return t;
        status_ = work_.steps == max_steps ? Status::too_many_steps : Status::no_convergence;
        return t;
      }
      ++work_.steps;
      const double t_before = t;
      t = start + static_cast<double>(i + 1) * step_;
      note(t, now);
      look_between(t_before, t, before, now);
      // Apart and parting, seen twice: samples begin to press only a little after the surfaces meet.
      const double gap = least_gap(now);
      const bool clear = gap >= 0, parting = clear && !(gap < least_gap(before));
      n_clear = clear ? n_clear + 1 : 0;
      n_parting = parting ? n_parting + 1 : 0;
      pressed = pressed || !clear;
      if (i % look_every == 0 && !sound(now)) return t;
      if (!pressed) soundness_.begin(now);
      if (!flies_ || n_parting < least_patience || n_clear < patience) continue;
      if (!sound(now) || pressed || !comes_in(now, t)) return t;
      n_clear = 0;
      patience = std::min(2 * patience, most_patience);
    }
    sound(now);
    return t;
  }

  // States since the last look are given up where it finds the motion unsound.
  bool sound(const std::vector<ContactState>& now) {
    status_ = soundness_(now);
    if (status_ == Status::ok) n_sound_ = n_states();
    keep(n_sound_);
    return status_ == Status::ok;
  }

  // Whether the surface of a body of which no sample has pressed as yet goes on into an obstacle: it is one touch.
  bool comes_in(const std::vector<ContactState>& now, double t) {
    std::vector<BodyFlight> flights;
    for (size_t b = 0; b < now.size(); ++b) flights.emplace_back(plans_[b].body, now[b].body, t);
    return meetings_.next(flights, t + step_, true).has_value();
  }

  // At the touch itself: a body may press from the start.
  void look_at(double t, const std::vector<ContactState>& now) {
    while (more() && next_time() <= t)
      for (size_t b = 0; b < now.size(); ++b)
        record(motions_[b], now[b].body, now[b].load.force, now[b], now[b].load.stored,
               mechanical_energy(plans_[b].body, now[b].body) + now[b].load.stored);
  }

  void look_between(double t_before, double t, const std::vector<ContactState>& from,
                    const std::vector<ContactState>& to) {
    while (more() && next_time() <= t) {
      const double x = std::min(1.0, (next_time() - t_before) / step_);
      for (size_t k = 0; k < from.size(); ++k) {
        const ContactState &a = from[k], &b = to[k];
        const FloatingBody& body = plans_[k].body;
        ContactState of = a;
        of.impulse = mean<Vector3d>(a.impulse, b.impulse, x);
        of.dissipated = mean(a.dissipated, b.dissipated, x);
        const double energy_a = mechanical_energy(body, a.body) + a.load.stored,
                     energy_b = mechanical_energy(body, b.body) + b.load.stored;
        record(motions_[k], between(body, a.body, b.body, step_, x), mean<Vector3d>(a.load.force, b.load.force, x), of,
               mean(a.load.stored, b.load.stored, x), mean(energy_a, energy_b, x));
      }
    }
  }

  std::span<const ImpactPlan> plans_;
  double step_;
  const VectorXd& times_;
  ContactStepper stepper_;
  Soundness soundness_;
  Meetings meetings_;
  bool flies_;
  size_t n_sound_ = 0;  // states
  std::vector<TouchLog> logs_;
  std::vector<ImpactMotion> motions_;
  Work work_;
  Status status_ = Status::ok;
  int patience_ = least_patience;  // doubled where flights turn out too short to be worth it: surfaces that chatter
};

}  // namespace

std::vector<ImpactMotion> impact_motions(std::span<const ImpactPlan> plans, const VectorXd& times) {
  return Run(plans, times).run();
}

ImpactMotion impact_motion(const ImpactPlan& plan, const VectorXd& times) {
  return std::move(impact_motions({&plan, 1}, times).front());
}

}  // namespace mb
