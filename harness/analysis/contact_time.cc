// Where the time of a modal run in contact goes.
#include <algorithm>
#include <cmath>

#include "harness/analysis/contact_tables.h"
#include "harness/measure.h"
#include "modal/contact/contact_load.h"
#include "modal/contact/meetings.h"
#include "modal/frame/spin.h"

namespace mb {

namespace {

Finding part_table() {
  return table("contact", "contact-time", "Where the time of a run goes",
               "The motion alone, nothing reconstructed. Search: for the next touch of surfaces, once a "
               "flight. Loads: gaps and law at the samples that can press, their sums, and the balance of static "
               "shapes; timed over the run's own states. Steps: frame and modes, with all else that a run does: what "
               "is left of the whole. Reconstruction: displacements at all evaluation points for the samples of the "
               "study. Medians; shares are of the whole. Empty: lost in the noise of the others.",
               {{"method", ""},
                {"modes r", ""},
                {"dt", "s"},
                {"part", ""},
                {"calls", ""},
                {"time", "s"},
                {"time a call", "s"},
                {"share", "-"}});
}

Finding run_table() {
  return table(
      "contact", "contact-time-runs", "What a run takes",
      "The largest step of the study whose motion stays stable. Visited: samples of the surface that a contact "
      "evaluation looks at, of all there are. The real-time factor is simulated over computing time of the "
      "motion, and of the motion with displacements at all evaluation points for every sample of the study.",
      {{"method", ""},
       {"modes r", ""},
       {"static shapes", ""},
       {"dt", "s"},
       {"status", ""},
       {"steps", ""},
       {"samples", ""},
       {"visited", ""},
       {"time", "s"},
       {"spread", "s"},
       {"real-time factor", "-"},
       {"with displacements", "-"}});
}

using Plans = std::vector<ImpactPlan>;

// The states at the ends of steps while the first body touches.
struct Steps {
  VectorXd t;
  std::vector<ImpactMotion> motions;              // one a body
  std::vector<std::vector<FlightBegun>> flights;  // likewise
};
Steps steps_of(const Plans& plans, double end) {
  const std::vector<ImpactMotion> motions = impact_motions(plans, VectorXd::Constant(1, end));
  std::vector<double> t;
  for (const Touch& touch : motions.front().contact.touches)
    for (double now = touch.start; now <= std::min(touch.end, end); now += plans.front().step) t.push_back(now);
  Steps steps{Eigen::Map<const VectorXd>(t.data(), std::ssize(t)), {}, {}};
  for (const ImpactMotion& motion : motions) steps.flights.push_back(motion.flights);
  steps.motions = impact_motions(plans, steps.t);
  steps.motions.front().work = motions.front().work;
  return steps;
}

void search_again(const Plans& plans, const std::vector<std::vector<FlightBegun>>& begun, double end) {
  Meetings meetings(plans);
  for (std::size_t i = 0; i < begun.front().size(); ++i) {
    std::vector<BodyFlight> flights;
    for (std::size_t b = 0; b < plans.size(); ++b)
      flights.emplace_back(plans[b].body, begun[b][i].from, begun[b][i].start);
    meetings.next(flights, end, i > 0);
  }
}

// Where the stepper begins its search for the static shapes: the last two steps point there.
VectorXd ahead(const std::vector<BodyState>& states, std::size_t i) {
  const VectorXd& last = states[i - 1].s;
  return i < 2 ? last : VectorXd(2 * last - states[i - 2].s);
}

struct Loads {
  Timing timing;
  double visited;  // samples a call
};
Loads loads_over(const Plans& plans, const std::vector<ImpactMotion>& motions) {
  std::vector<const FloatingBody*> bodies;
  for (const ImpactPlan& plan : plans) bodies.push_back(&plan.body);
  ContactLoads loads(bodies);
  std::vector<ContactState> now(plans.size());
  std::vector<VectorXd> rate(plans.size());
  const std::size_t n = motions.front().states.size();
  double visited = 0;
  const auto pass = [&] {
    visited = 0;
    loads.touch();
    for (std::size_t i = 1; i < n; ++i) {
      std::vector<Looked> looked;
      for (std::size_t b = 0; b < plans.size(); ++b) {
        now[b].body = motions[b].states[i];
        now[b].body.s = ahead(motions[b].states, i);
        rate[b] = rates(plans[b].body, now[b].body);
        looked.push_back({&now[b].body, angular_velocity(plans[b].body, now[b].body), &rate[b], &now[b].load});
      }
      loads.begin_step(static_shapes(now), plans.front().step);
      loads(looked);
      for (const ContactState& state : now) visited += static_cast<double>(state.load.n_visited);
    }
  };
  pass();
  return {measure(pass), visited / std::max(1.0, static_cast<double>(n) - 1)};
}

class Account {
 public:
  Account(const AnalysisContext& context, Finding& parts, Finding& runs)
      : scene_(*context.scene), exact_(context.catalogue.integrator("exact")), parts_(parts), runs_(runs) {}

  void add(const ContactBasis& asked) {
    std::vector<double> steps = scene_.study.contact_steps;
    std::ranges::sort(steps, std::greater<>());
    for (const double h : steps) {
      const Plans plans = impact_plans(*asked.bases, ContactScheme::exact, h);
      const Steps run = steps_of(plans, scene_.duration);
      if (run.motions.front().status != Status::ok && h > steps.back()) continue;
      account(asked, plans, run);
      return;
    }
  }

 private:
  void account(const ContactBasis& asked, const Plans& plans, const Steps& run) {
    const ImpactPlan& plan = plans.front();
    const ImpactMotion& motion = run.motions.front();
    const VectorXd end = VectorXd::Constant(1, scene_.duration);
    const Timing whole = measure([&] { impact_motions(plans, end); });
    const double search = measure([&] { search_again(plans, run.flights, scene_.duration); }).median;
    const Loads loads = loads_over(plans, run.motions);
    Settings settings;
    settings.time_step = plan.step;
    const auto prepared = prepare_floating(asked.bases, exact_, settings);
    const Sampling all{.t = sample_times(scene_), .strain = false};
    const double shown = measure([&] { prepared->simulate(all); }).median;
    const double n_calls = static_cast<double>(motion.states.size()) - 1,
                 n_steps = static_cast<double>(motion.work.steps);
    // What is left of the whole: a part that is lost in the noise of the others is none.
    const auto rest = [](double seconds) { return seconds > 0 ? seconds : std::nan(""); };
    const double stepping = rest(whole.median - search - loads.timing.median),
                 reconstruction = rest(shown - whole.median);
    const double sum = std::max(shown, search + loads.timing.median);
    const double r = static_cast<double>(plan.body.n_modes());
    const auto part = [&](const char* name, double calls, double seconds) {
      parts_.rows.push_back({asked.of.method, r, plan.step, name, calls, number(seconds), number(seconds / calls),
                             number(seconds / sum)});
    };
    part("search for touches", static_cast<double>(run.flights.front().size()), search);
    part("loads of contact", n_calls, loads.timing.median);
    part("steps", n_steps, stepping);
    part("reconstruction", static_cast<double>(all.t.size()), reconstruction);
    Index n_samples = 0;
    Index n_static = 0;
    for (const ImpactPlan& each : plans) {
      n_static += each.body.n_static();
      for (const SampledContact& contact : each.body.contacts) n_samples += contact.samples.w.size();
    }
    runs_.rows.push_back({asked.of.method, r, count(n_static), plan.step, to_string(motion.status), n_steps,
                          count(n_samples), loads.visited, whole.median, whole.spread, scene_.duration / whole.median,
                          scene_.duration / shown});
  }

  const Scene& scene_;
  const Integrator& exact_;
  Finding &parts_, &runs_;
};

}  // namespace

std::vector<Finding> contact_times(const std::vector<ContactBasis>& bases, const AnalysisContext& context) {
  Finding parts = part_table(), runs = run_table();
  Account account(context, parts, runs);
  for (const ContactBasis& basis : bases) account.add(basis);
  return {runs, parts};
}

}  // namespace mb
