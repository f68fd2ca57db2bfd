// What the stiffness of the contact layer, which the scene states or leaves to `auto`, does to the answer.
#include <fmt/format.h>

#include "cases/contract/touchdown.h"
#include "harness/analysis/analyses.h"
#include "harness/analysis/contact_tables.h"
#include "harness/analysis/first_impact.h"

namespace mb {

namespace {

const double factors[] = {0.5, 1, 2};

Finding stiffness_table() {
  return table("contact-stiffness", "contact-stiffness", "What the stiffness of the layer does",
               "The first contact with the layer's stiffness halved, as it is, and doubled; changes are against `as it "
               "is` of the same contender. A layer of stiffness k adds F/(k pi a^2) to the approach of a contact of "
               "radius a: where k a/E* is a hundred, halving it changes the approach by 0.3 %. Bars: what steps twice "
               "as long, or ten times the tolerance, move; of changes those of both answers.",
               {{"contact", ""},
                {"contender", ""},
                {"modes r", ""},
                {"factor", "-"},
                {"stiffness", "Pa/m"},
                {"k a/E*", "-"},
                {"first touch", "s"},
                {"duration", "s"},
                {"peak force", "N"},
                {"impulse", "N s"},
                {"change of duration", "-"},
                {"change of peak force", "-"},
                {"change of impulse", "-"}});
}

}  // namespace

std::vector<Finding> contact_stiffness(const AnalysisContext& context) {
  Finding found = stiffness_table();
  const Scene& scene = *context.scene;
  const Trajectory& truth = context.truth.finer;
  ContactVariants variants(context);
  const Touchdown down = touchdown(scene, scene.bodies.front());
  const auto add = [&](const Meeting& meeting, const std::string& contender, const ContactContender& answer) {
    const Scene stated = variants.with_stiffness(meeting.contact, meeting.size.stiffness);
    const FirstImpact as_it_is = first_impact(variants.simulate(stated, answer), truth),
                      coarse = first_impact(variants.simulate_coarsely(stated, answer), truth);
    const auto change = [](double a, double b) { return a / b - 1; };
    const double of_duration = std::abs(change(coarse.duration, as_it_is.duration)),
                 of_peak = std::abs(change(coarse.peak, as_it_is.peak)),
                 of_impulse = std::abs(change(coarse.impulse, as_it_is.impulse));
    for (const double factor : factors) {
      const double k = factor * meeting.size.stiffness, twice = factor == 1 ? 0 : 2;
      const FirstImpact now =
          factor == 1 ? as_it_is
                      : first_impact(variants.simulate(variants.with_stiffness(meeting.contact, k), answer), truth);
      const bool lumped = scene.contacts[meeting.contact].law == ContactLaw::hertz;
      found.rows.push_back({scene.contacts[meeting.contact].obstacle, contender,
                            answer.modes < 0 ? not_applicable() : count(answer.modes), factor, k,
                            lumped ? not_applicable() : number(k * meeting.size.radius / meeting.size.modulus),
                            now.start, now.duration, now.peak, now.impulse, change(now.duration, as_it_is.duration),
                            change(now.peak, as_it_is.peak), change(now.impulse, as_it_is.impulse)});
      bar_last_row(found, {{"first touch", std::abs(coarse.start - as_it_is.start)},
                           {"duration", of_duration * now.duration},
                           {"peak force", of_peak * now.peak},
                           {"impulse", of_impulse * std::abs(now.impulse)},
                           {"change of duration", twice * of_duration},
                           {"change of peak force", twice * of_peak},
                           {"change of impulse", twice * of_impulse}});
    }
  };
  for (const Meeting& meeting : down.meetings) {
    if (!std::isfinite(meeting.t)) continue;
    for (const ContactContender& answer : variants.contenders())
      add(meeting, answer.modes < 0 ? "full order, the truth's tolerance" : answer.method, answer);
  }
  std::vector<Finding> all{std::move(found)};
  for (Finding& of : contact_conditions(variants, context)) all.push_back(std::move(of));
  return all;
}

}  // namespace mb
