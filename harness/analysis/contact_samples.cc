// What the number of samples does that carry a modal contact.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "harness/analysis/contact_tables.h"
#include "harness/analysis/first_impact.h"

namespace mb {

namespace {

const double finest[] = {2, 1, 0.5, 0.25};  // [-] of the contact's radius, the last one taken as exact

Finding samples_table() {
  return table("contact", "contact-samples", "What the number of samples does",
               "The first contact with samples twice, once, half and a quarter of the contact's radius in size where "
               "the bodies touch first, growing with the distance; contenders use a half. Changes are against the "
               "finest, the most modes and the least step of the study in all. Bars of what is told against the truth: "
               "its distance to its coarser mesh and between two tolerances; of values their distance to the finest "
               "and what another mesh moves in full order and, of these and of changes, too, how far the finest are "
               "from the next.",
               {{"method", ""},
                {"modes r", ""},
                {"size / a", "-"},
                {"samples", ""},
                {"duration", "s"},
                {"peak force", "N"},
                {"impulse", "N s"},
                {"change of duration", "-"},
                {"change of peak force", "-"},
                {"change of impulse", "-"},
                {"peak force against truth", "-"},
                {"impulse against truth", "-"}});
}

Index n_samples(const FloatingBases& bases) {
  Index n = 0;
  for (const FloatingBasis& basis : bases)
    for (const SampledContact& contact : basis.body.contacts) n += contact.samples.w.size();
  return n;
}

// [-] How far the truth itself may be off in one of its numbers.
double bar_of(const TruthSet& truth, double per_distance, double FirstImpact::*part) {
  const auto of = [&](const Trajectory& one) { return first_impact(one, truth.finer).*part; };
  return per_distance * std::abs(of(truth.coarser) / of(truth.finer) - 1) +
         std::abs(of(truth.loose) / of(truth.same_mesh) - 1);
}

// The last row's bars of values and changes: `now` against the finest, and these against the next.
void bar_values(Finding& found, const FirstImpact& now, const FirstImpact& next, const FirstImpact& best,
                const AnalysisContext& context) {
  constexpr std::tuple<const char*, const char*, double FirstImpact::*> told[] = {
      {"duration", "change of duration", &FirstImpact::duration},
      {"peak force", "change of peak force", &FirstImpact::peak},
      {"impulse", "change of impulse", &FirstImpact::impulse}};
  for (const auto& [value, change, part] : told) {
    const double off = std::abs(now.*part - best.*part), left = std::abs(next.*part - best.*part);
    const double mesh = mesh_bar(context, part) * std::abs(now.*part);
    bar_last_row(found, {{value, off + left + mesh}, {change, left / std::abs(best.*part)}});
  }
}

}  // namespace

Finding contact_samples(const ContactVariants& variants, const AnalysisContext& context) {
  Finding found = samples_table();
  const auto sampled = [](const ContactPair& pair) { return pair.law == ContactLaw::penalty; };
  if (!std::ranges::any_of(context.scene->contacts, sampled)) return found;
  const Trajectory& truth = context.truth.finer;
  const FirstImpact real = first_impact(truth, truth);
  const double F = context.truth.per_distance.mean;
  const double of_peak = bar_of(context.truth, F, &FirstImpact::peak),
               of_impulse = bar_of(context.truth, F, &FirstImpact::impulse);
  for (ContactContender of : variants.contenders()) {
    if (of.modes < 0) continue;
    std::vector<FirstImpact> impacts;
    std::vector<Index> counts;
    for (const double size : finest) {
      of.finest_sample = size;
      impacts.push_back(first_impact(variants.simulate(*context.scene, of), truth));
      counts.push_back(n_samples(*variants.bases(*context.scene, of)));
    }
    const FirstImpact& best = impacts.back();
    const auto change = [](double a, double b) { return FindingCell(a / b - 1); };
    for (size_t i = 0; i < impacts.size(); ++i) {
      const FirstImpact& now = impacts[i];
      found.rows.push_back({of.method, count(of.modes), finest[i], count(counts[i]), now.duration, now.peak,
                            now.impulse, change(now.duration, best.duration), change(now.peak, best.peak),
                            change(now.impulse, best.impulse), change(now.peak, real.peak),
                            change(now.impulse, real.impulse)});
      bar_last_row(found, {{"peak force against truth", of_peak * std::abs(now.peak / real.peak)},
                           {"impulse against truth", of_impulse * std::abs(now.impulse / real.impulse)}});
      bar_values(found, now, impacts[impacts.size() - 2], best, context);
    }
  }
  return found;
}

}  // namespace mb
