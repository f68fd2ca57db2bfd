// What contact is in a case: its layer, the polynomials and samples that carry it, where the time goes, its forces.
#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/contact_tables.h"
#include "harness/metrics/contact_metrics.h"

namespace mb {

namespace {

constexpr int n_mode_counts = 3;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Finding force_table() {
  return table(
      "contact", "force-history", "Contact force over time",
      "Along the direction of the truth's largest force, at the samples of the study around the first touch; "
      "the modal answers with the least step of the study. Bars at that time: of the truth, by its distance to its "
      "coarser mesh and between two tolerances; of modes what steps twice as long move.",
      {{"contender", ""}, {"modes r", ""}, {"time", "s"}, {"normal force", "N"}});
}

VectorXd force_along(const Trajectory& one, const Vector3d& along) {  // [N]
  return one.bodies.front().contact.force.transpose() * along;
}

// [N] How far the truth's force in that direction may be off, at each of its times.
VectorXd bar_along(const TruthSet& truth, const Vector3d& along, double per_distance) {
  const auto force = [&](const Trajectory& one) { return force_along(one, along); };
  if (truth.exact) {
    const VectorXd exact = force(*truth.exact);
    return VectorXd::Constant(exact.size(), truth.exact_bar * exact.cwiseAbs().maxCoeff());
  }
  return per_distance * (force(truth.finer) - force(truth.coarser)).cwiseAbs() +
         (force(truth.same_mesh) - force(truth.loose)).cwiseAbs();
}

}  // namespace

Finding force_history(const std::vector<ContactBasis>& bases, const AnalysisContext& context) {
  Finding found = force_table();
  const Scene& scene = *context.scene;
  const bool exact = context.truth.exact.has_value();
  const Trajectory& truth = exact ? *context.truth.exact : context.truth.finer;
  const ContactHistory& contact = truth.bodies.front().contact;
  Index peak = 0;
  if (contact.touches.empty() || !(contact.force.colwise().norm().maxCoeff(&peak) > 0)) return found;
  const Vector3d along = contact.force.col(peak).normalized();
  const Touch first = first_contact(contact.touches, contact.touches)->whole;
  const double length = std::isfinite(first.end) ? first.end - first.start : scene.duration - first.start;
  const VectorXd truth_bar = bar_along(context.truth, along, context.truth.per_distance.mean);
  const auto add = [&](const std::string& name, FindingCell r, const Trajectory& answer, const VectorXd& bar) {
    if (answer.status != Status::ok) return;
    for (Index k = 0; k < answer.t.size(); ++k) {
      if (answer.t[k] < first.start - 0.2 * length || answer.t[k] > first.start + 1.5 * length) continue;
      found.rows.push_back({name, r, answer.t[k], along.dot(answer.bodies.front().contact.force.col(k))});
      found.bars.push_back({nan, nan, nan, bar[k]});
    }
  };
  add(exact ? "truth, exact" : "truth, finer", not_applicable(), truth, truth_bar);
  for (const auto& [of, prepared_bases] : bases) {
    const auto stepped_by = [&](double step) {
      Settings settings;
      settings.time_step = step;
      return prepare_floating(prepared_bases, context.catalogue.integrator("exact"), settings)
          ->simulate({.t = sample_times(scene), .strain = false, .reconstruct = false});
    };
    const double least = std::ranges::min(scene.study.contact_steps);
    const Trajectory answer = stepped_by(least), coarse = stepped_by(2 * least);
    const bool known = answer.status == Status::ok && coarse.status == Status::ok;
    add(of.method, count(prepared_bases->front().body.n_modes()), answer,
        known ? VectorXd((force_along(answer, along) - force_along(coarse, along)).cwiseAbs())
              : VectorXd::Constant(truth.t.size(), nan));
  }
  return found;
}

std::vector<Finding> contact(const AnalysisContext& context) {
  const ContactVariants variants(context);
  std::vector<ContactBasis> bases;
  for (const int r : few(mode_counts(context), n_mode_counts))
    for (const char* method : {"eigenmodes", "static-correction"}) {
      const ContactContender of{method, r};
      bases.push_back({of, variants.bases(*context.scene, of)});
    }
  for (const char* method : {"linear", "quadratic"}) {
    if (std::ranges::count(context.scene->study.methods, method) == 0) continue;
    const ContactContender of{method, 0};
    bases.push_back({of, variants.bases(*context.scene, of)});
  }
  std::vector<Finding> found{contact_meetings(*context.scene), contact_geometry(bases), force_history(bases, context)};
  found.push_back(contact_samples(variants, context));
  for (Finding& times : contact_times(bases, context)) found.push_back(std::move(times));
  return found;
}

}  // namespace mb
