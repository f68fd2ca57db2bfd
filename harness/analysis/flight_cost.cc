// What a modal run costs: the steps in contact, not the flight before.
#include <cmath>

#include "harness/analysis/analyses.h"
#include "harness/analysis/contact_variants.h"
#include "harness/analysis/power_law.h"
#include "harness/measure.h"

namespace mb {

namespace {

const double flights[] = {1, 30, 1000};  // [-] durations of the contact
const int refinements[] = {1, 2, 4};     // of the step

Finding cost_table() {
  return table("flight-cost", "flight-cost", "What a run costs: time in contact, not in flight",
               "The first body thrown without gravity, so that it meets its obstacle after longer and longer flights, "
               "at the speed it has in the scene; then the same with smaller and smaller steps in contact. Only the "
               "motion is computed, nothing is reconstructed. Times are medians.",
               {{"varied", ""},
                {"method", ""},
                {"modes r", ""},
                {"flight time", "s"},
                {"contact time", "s"},
                {"dt", "s"},
                {"steps", ""},
                {"contact evaluations", ""},
                {"time", "s"},
                {"spread", "s"},
                {"time a step", "s"},
                {"real-time factor", "-"}});
}

Finding exponent_table() {
  return table("flight-cost", "flight-cost-exponents", "How the cost of a run grows",
               "Exponent p of cost ~ x^p by least squares in logarithms, x the flight time or the number of steps in "
               "contact.",
               {{"cost", ""},
                {"grows with", ""},
                {"runs fitted", ""},
                {"exponent", "-"},
                {"standard error", "-"},
                {"expected", "-"}});
}

struct Run {
  double flight, contact, steps, evaluations, seconds;
};

void add_fit(Finding& found, const std::string& cost, const std::string& with, const std::vector<Run>& runs,
             double Run::*x, double Run::*y, double expected) {
  VectorXd a(std::ssize(runs)), b(std::ssize(runs));
  for (Index i = 0; i < a.size(); ++i) {
    a[i] = runs[static_cast<std::size_t>(i)].*x;
    b[i] = runs[static_cast<std::size_t>(i)].*y;
  }
  const PowerLaw law = power_law(a, b);
  found.rows.push_back({cost, with, count(law.n_points), law.exponent, law.standard_error, expected});
}

}  // namespace

std::vector<Finding> flight_cost(const AnalysisContext& context) {
  Finding costs = cost_table(), exponents = exponent_table();
  const ContactVariants variants(context);
  const ContactContender contender = variants.contenders().at(1);
  const Scene& scene = *context.scene;
  const double T = touchdown(scene, scene.bodies.front()).meetings.front().size.duration;
  const Integrator& exact = context.catalogue.integrator("exact");
  const auto thrown = [&](double flight) { return variants.bases(variants.with_flight(flight, 3 * T), contender); };
  const auto run = [&](const std::string& varied, const std::shared_ptr<const FloatingBases>& bases, double flight,
                       int refinement) {
    Settings settings;
    settings.time_step = contender.time_step / refinement;
    const auto prepared = prepare_floating(bases, exact, settings);
    const double duration = bases->front().scene->duration;
    const Sampling sampling{.t = VectorXd::Constant(1, duration), .strain = false, .reconstruct = false};
    const Trajectory answer = prepared->simulate(sampling);
    const Timing timing = measure([&] { prepared->simulate(sampling); });
    double contact = 0;
    for (const Touch& touch : answer.bodies.front().contact.touches)
      contact += std::min(touch.end, duration) - touch.start;
    const Run one{flight, contact, static_cast<double>(answer.work.steps),
                  static_cast<double>(answer.work.load_evaluations), timing.median};
    costs.rows.push_back({varied, contender.method, count(prepared->modes_used()), one.flight, one.contact,
                          settings.time_step, one.steps, one.evaluations, one.seconds, timing.spread,
                          one.seconds / one.steps, duration / one.seconds});
    return one;
  };
  std::vector<Run> by_flight, by_step;
  for (const double flight : flights) by_flight.push_back(run("flight", thrown(flight * T), flight * T, 1));
  const auto soon = thrown(T);
  for (const int refinement : refinements) by_step.push_back(run("step", soon, T, refinement));
  add_fit(exponents, "steps", "flight time", by_flight, &Run::flight, &Run::steps, 0);
  add_fit(exponents, "time", "flight time", by_flight, &Run::flight, &Run::seconds, 0);
  add_fit(exponents, "contact evaluations", "steps in contact", by_step, &Run::steps, &Run::evaluations, 1);
  add_fit(exponents, "time", "steps in contact", by_step, &Run::steps, &Run::seconds, 1);
  return {costs, exponents};
}

}  // namespace mb
