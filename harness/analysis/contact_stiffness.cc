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
               "as long, or ten times the tolerance, move, and of values what another mesh moves in full order; of "
               "changes, which are all of this mesh, the steps of both answers.",
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

// One layer: the first contact, and as coarser steps have it.
struct Varied {
  double factor;
  FirstImpact fine, coarse;

  double bar(double FirstImpact::*what) const { return std::abs(coarse.*what - fine.*what); }
};

// What stands in the row's last columns, and the bars of these.
void finish_row(Finding& found, const Varied& now, const Varied& as_it_is, const AnalysisContext& context) {
  constexpr double FirstImpact::*all[] = {&FirstImpact::start, &FirstImpact::duration, &FirstImpact::peak,
                                          &FirstImpact::impulse};
  constexpr const char* names[] = {"first touch", "duration", "peak force", "impulse"};
  std::vector<std::pair<const char*, double>> bars;
  std::vector<FindingCell>& row = found.rows.back();
  for (size_t i = 0; i < 4; ++i) {
    row.emplace_back(now.fine.*all[i]);
    bars.emplace_back(names[i], now.bar(all[i]) + mesh_bar(context, all[i]) * std::abs(now.fine.*all[i]));
  }
  constexpr const char* changes[] = {"change of duration", "change of peak force", "change of impulse"};
  for (size_t i = 1; i < 4; ++i) {
    const double a = now.fine.*all[i], b = as_it_is.fine.*all[i];
    row.emplace_back(a / b - 1);
    const double bar = now.factor == 1 ? 0 : (now.bar(all[i]) + as_it_is.bar(all[i]) * std::abs(a / b)) / std::abs(b);
    bars.emplace_back(changes[i - 1], bar);
  }
  bar_last_row(found, bars);
}

}  // namespace

std::vector<Finding> contact_stiffness(const AnalysisContext& context) {
  Finding found = stiffness_table();
  const Scene& scene = *context.scene;
  const Trajectory& truth = context.truth.finer;
  ContactVariants variants(context);
  const Touchdown down = touchdown(scene, scene.bodies.front());
  const auto add = [&](const Meeting& meeting, const std::string& contender, const ContactContender& answer) {
    const auto of = [&](double factor) {
      const Scene varied = variants.with_stiffness(meeting.contact, factor * meeting.size.stiffness);
      return Varied{factor, first_impact(variants.simulate(varied, answer), truth),
                    first_impact(variants.simulate_coarsely(varied, answer), truth)};
    };
    const Varied as_it_is = of(1);
    for (const double factor : factors) {
      const Varied now = factor == 1 ? as_it_is : of(factor);
      const double k = factor * meeting.size.stiffness;
      const bool lumped = scene.contacts[meeting.contact].law == ContactLaw::hertz;
      found.rows.push_back({scene.contacts[meeting.contact].obstacle, contender,
                            answer.modes < 0 ? not_applicable() : count(answer.modes), factor, k,
                            lumped ? not_applicable() : number(k * meeting.size.radius / meeting.size.modulus)});
      finish_row(found, now, as_it_is, context);
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
