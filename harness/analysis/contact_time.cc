// Where the time of a modal run in contact goes.
#include <algorithm>
#include <cmath>

#include "harness/analysis/contact_tables.h"
#include "harness/measure.h"
#include "modal/contact/contact_load.h"
#include "modal/contact/next_touch.h"

namespace mb {

namespace {

Finding part_table() {
  return table("contact", "contact-time", "Where the time of a run goes",
               "The motion alone, nothing reconstructed. Search: for the next touch of surfaces, in closed form, once "
               "a flight. Loads: "
               "gaps and law at the samples that can press, their sums, and the balance of static shapes; timed over "
               "the run's own states. Steps: frame and modes, with all else that a run does. Reconstruction: "
               "displacements at all evaluation points for the samples of the study. Medians; shares are of their sum.",
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

// The states at the ends of steps while the body touches.
struct Steps {
  VectorXd t;
  ImpactMotion motion;
  std::vector<FlightBegun> flights;
};
Steps steps_of(const ImpactPlan& plan, double end) {
  const ImpactMotion motion = impact_motion(plan, VectorXd::Constant(1, end));
  std::vector<double> t;
  for (const Touch& touch : motion.contact.touches)
    for (double now = touch.start; now <= std::min(touch.end, end); now += plan.step) t.push_back(now);
  Steps steps{Eigen::Map<const VectorXd>(t.data(), std::ssize(t)), {}, motion.flights};
  steps.motion = impact_motion(plan, steps.t);
  steps.motion.work = motion.work;
  return steps;
}

void search_again(const ImpactPlan& plan, const std::vector<FlightBegun>& flights, double end) {
  for (std::size_t i = 0; i < flights.size(); ++i)
    next_touch(plan, BodyFlight(plan.body, flights[i].from, flights[i].start), end, i > 0);
}

struct Loads {
  Timing timing;
  double visited;  // samples a call
};
Loads loads_over(const ImpactPlan& plan, const std::vector<BodyState>& states) {
  ContactLoads loads(plan.body);
  ContactLoad load;
  double visited = 0;
  const auto pass = [&] {
    visited = 0;
    loads.touch();
    for (std::size_t i = 1; i < states.size(); ++i) {
      BodyState now = states[i];
      now.s = states[i - 1].s;
      loads.begin_step(now.s, plan.step);
      loads(now, angular_velocity(plan.body, now), load);
      visited += static_cast<double>(load.n_visited);
    }
  };
  pass();
  return {measure(pass), visited / std::max(1.0, static_cast<double>(states.size()) - 1)};
}

class Account {
 public:
  Account(const AnalysisContext& context, Finding& parts, Finding& runs)
      : scene_(*context.scene), exact_(context.catalogue.integrator("exact")), parts_(parts), runs_(runs) {}

  void add(const ContactBasis& asked) {
    std::vector<double> steps = scene_.study.contact_steps;
    std::ranges::sort(steps, std::greater<>());
    for (const double h : steps) {
      const ImpactPlan plan = impact_plan(*asked.basis, ContactScheme::exact, h);
      const Steps run = steps_of(plan, scene_.duration);
      if (run.motion.status != Status::ok && h > steps.back()) continue;
      account(asked, plan, run);
      return;
    }
  }

 private:
  void account(const ContactBasis& asked, const ImpactPlan& plan, const Steps& run) {
    const VectorXd end = VectorXd::Constant(1, scene_.duration);
    const Timing whole = measure([&] { impact_motion(plan, end); });
    const double search = measure([&] { search_again(plan, run.flights, scene_.duration); }).median;
    const Loads loads = loads_over(plan, run.motion.states);
    Settings settings;
    settings.time_step = plan.step;
    const auto prepared = prepare_floating(asked.basis, exact_, settings);
    const Sampling all{.t = sample_times(scene_), .strain = false};
    const double shown = measure([&] { prepared->simulate(all); }).median;
    const double n_calls = static_cast<double>(run.motion.states.size()) - 1,
                 n_steps = static_cast<double>(run.motion.work.steps);
    const double stepping = std::max(0.0, whole.median - search - loads.timing.median);
    const double reconstruction = std::max(0.0, shown - whole.median);
    const double sum = search + loads.timing.median + stepping + reconstruction;
    const double r = static_cast<double>(plan.body.n_modes());
    const auto part = [&](const char* name, double calls, double seconds) {
      parts_.rows.push_back({asked.of.method, r, plan.step, name, calls, seconds, seconds / calls, seconds / sum});
    };
    part("search for touches", static_cast<double>(run.flights.size()), search);
    part("loads of contact", n_calls, loads.timing.median);
    part("steps", n_steps, stepping);
    part("reconstruction", static_cast<double>(all.t.size()), reconstruction);
    Index n_samples = 0;
    for (const SampledContact& contact : plan.body.contacts) n_samples += contact.samples.w.size();
    runs_.rows.push_back({asked.of.method, r, count(plan.body.n_static()), plan.step, to_string(run.motion.status),
                          n_steps, count(n_samples), loads.visited, whole.median, whole.spread,
                          scene_.duration / whole.median, scene_.duration / shown});
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
