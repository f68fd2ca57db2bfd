// What modal contact is made of: the layer that each obstacle meets, and the polynomials and samples that carry it.
#include <algorithm>
#include <cmath>

#include "harness/analysis/analyses.h"
#include "harness/analysis/contact_variants.h"

namespace mb {

namespace {

Finding meeting_table() {
  return table("contact-model", "contact-meetings", "How the body comes to its obstacles",
               "Of the rigid body, in closed form, before anything deforms; sizes are Hertz's, of a flat end a bar's. "
               "Stiffness `auto` is 100 E*/a: the layer then adds 0.3 % to the approach of a sphere.",
               {{"obstacle", ""},
                {"law", ""},
                {"stiffness", "Pa/m"},
                {"stated", ""},
                {"E*", "Pa"},
                {"a", "m"},
                {"k a/E*", "-"},
                {"first touch", "s"},
                {"speed", "m/s"},
                {"approach", "m"},
                {"duration", "s"},
                {"force", "N"}});
}

Finding geometry_table() {
  return table(
      "contact-model", "contact-geometry", "Modes as polynomials, where contact sees them",
      "Every mode is fitted by monomials up to the degree offered; residuals are over the mode's own root mean "
      "square, and its largest value; coefficients below 1e-10 of it in sum are dropped. Condition: of the "
      "scaled, weighted monomials. Samples: points on the exact surface.",
      {{"method", ""},
       {"modes r", ""},
       {"degree", ""},
       {"coefficients", ""},
       {"kept", ""},
       {"condition", "-"},
       {"residual", "-"},
       {"worst mode", "-"},
       {"largest", "-"},
       {"static shapes", ""},
       {"samples", ""}});
}

void add_meetings(Finding& found, const Scene& scene) {
  for (const Meeting& meeting : touchdown(scene, scene.bodies.front()).meetings) {
    const ContactPair& pair = scene.contacts[meeting.contact];
    const ContactSize& size = meeting.size;
    const bool lumped = pair.law == ContactLaw::hertz;
    found.rows.push_back({pair.obstacle, lumped ? "hertz, lumped [N/m^1.5]" : "penalty per area", size.stiffness,
                          pair.stiffness ? "given" : "auto", size.modulus, size.radius,
                          lumped ? not_applicable() : number(size.stiffness * size.radius / size.modulus), meeting.t,
                          size.speed, size.approach, size.duration, size.force});
  }
}

void add_geometry(Finding& found, const ContactContender& of, const FloatingBasis& basis) {
  const Regression& fit = basis.geometry;
  double square = 0, worst = 0, largest = 0, kept = 0;
  for (const ModeFit& mode : fit.modes) {
    square += mode.residual * mode.residual;
    worst = std::max(worst, mode.residual);
    largest = std::max(largest, mode.largest_residual);
    kept += static_cast<double>(mode.n_kept);
  }
  const double n = static_cast<double>(fit.modes.size());
  Index n_samples = 0;
  for (const SampledContact& contact : basis.body.contacts) n_samples += contact.samples.w.size();
  found.rows.push_back({of.method, n, count(fit.basis.monomials().degree()),
                        3 * n * static_cast<double>(fit.n_monomials), kept, fit.condition,
                        n > 0 ? std::sqrt(square / n) : 0, worst, largest, count(basis.body.n_static()),
                        count(n_samples)});
}

}  // namespace

std::vector<Finding> contact_model(const AnalysisContext& context) {
  Finding meetings = meeting_table(), geometry = geometry_table();
  add_meetings(meetings, *context.scene);
  const ContactVariants variants(context);
  for (const int r : mode_counts(context)) {
    const ContactContender of{"static-correction", r};
    add_geometry(geometry, of, *variants.basis(*context.scene, of));
  }
  return {meetings, geometry};
}

// The contact force over time, of truth and modes.
std::vector<Finding> force_history(const AnalysisContext& context) {
  Finding found =
      table("force-history", "force-history", "Contact force over time",
            "Along the direction of the truth's largest force, at the samples of the study around the first "
            "touch; the modal answers with the least step of the study.",
            {{"contender", ""}, {"modes r", ""}, {"time", "s"}, {"normal force", "N"}});
  const Trajectory& truth = context.truth.exact ? *context.truth.exact : context.truth.finer;
  const auto& contact = truth.bodies.front().contact;
  Index peak = 0;
  if (contact.touches.empty() || !(contact.force.colwise().norm().maxCoeff(&peak) > 0)) return {found};
  const Vector3d along = contact.force.col(peak).normalized();
  const Touch& first = contact.touches.front();
  const double length = std::isfinite(first.end) ? first.end - first.start : context.scene->duration - first.start;
  const auto add = [&](const std::string& name, FindingCell r, const Trajectory& answer) {
    if (answer.status != Status::ok) return;
    for (Index k = 0; k < answer.t.size(); ++k) {
      if (answer.t[k] < first.start - 0.2 * length || answer.t[k] > first.start + 1.5 * length) continue;
      found.rows.push_back({name, r, answer.t[k], along.dot(answer.bodies.front().contact.force.col(k))});
    }
  };
  add(context.truth.exact ? "truth, exact" : "truth, finer", not_applicable(), truth);
  const ContactVariants variants(context);
  for (ContactContender of : variants.contenders()) {
    if (of.modes < 0) continue;
    for (const int r : few(mode_counts(context), 2)) {
      of.modes = r;
      add(of.method, count(r), variants.simulate(*context.scene, of));
    }
  }
  return {found};
}

}  // namespace mb
