// C4 has two halves: rigid, linear and quadratic modes suffice for compact bodies, and do not for bodies whose
// dimensions are disparate. A compact body within the limit supports it, a disparate one beyond it does, too;
// of one kind alone the claim holds within limits at most.
#include <algorithm>
#include <cmath>

#include "reports/claim_instances.h"
#include "reports/number.h"

namespace mb {
namespace {

// [-] displacement error by which a shape is still the right one to the eye. Relative to the motion: relative to the
// body, whatever hardly moves would be right.
constexpr double visible = 0.1;
constexpr double disparate = 5;  // [-] largest over smallest extent beyond which a body counts as slender or thin

double aspect_ratio(const Shape& shape) {
  Vector3d extents = Vector3d::Ones();
  if (const auto* box = std::get_if<Box>(&shape)) extents = box->size;
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    extents = {2 * cylinder->radius, 2 * cylinder->radius, cylinder->length};
  }
  return extents.maxCoeff() / extents.minCoeff();
}

// Of the body that a record grades; none where the scene does not say.
std::optional<double> aspect_ratio(const Evaluation& evaluation, const Record& record) {
  const Scene* scene = scene_of(evaluation, record.case_name, record.profile);
  if (!scene) return std::nullopt;
  for (const Body& body : scene->bodies) {
    if (body.name == record.subject || scene->bodies.size() == 1) return aspect_ratio(body.shape);
  }
  return std::nullopt;
}

Instance instance_of(const Record& record, double aspect) {
  const bool compact = aspect <= disparate;
  const bool within = largest_error(record) <= visible, beyond = smallest_error(record) > visible;
  const Ruling ruling = !within && !beyond  ? Ruling::not_decided
                        : within == compact ? Ruling::holds
                                            : Ruling::does_not_hold;
  return {record.case_name, compact ? "compact" : "disparate", counted_error(record), ruling};
}

// Of every body, by runs of that method in closed form.
std::vector<Instance> instances_of(const Evaluation& evaluation, const std::string& method) {
  std::vector<Instance> all;
  for (const Run& run : evaluation.runs) {
    if (run.contender.method != method || run.contender.integrator != "exact") continue;
    for (const auto& [measure, record] : run.measures) {
      if (measure.metric != headline_metric || !is_against_best(run, measure) || !is_usable(record)) continue;
      const auto aspect = aspect_ratio(evaluation, record);
      if (aspect) all.push_back(instance_of(record, *aspect));
    }
  }
  return all;
}

// The claim speaks of both kinds: where one was not looked at, the other alone does not make it hold.
void limit_to_kinds_seen(Claim& claim, const std::vector<Instance>& instances) {
  if (claim.ruling == Ruling::not_measured) return;
  for (const char* kind : {"compact", "disparate"}) {
    if (std::any_of(instances.begin(), instances.end(), [&](const Instance& one) { return one.label == kind; }))
      continue;
    claim.limits += (claim.limits.empty() ? "" : "; ") + std::string(kind) + " bodies: not measured";
    if (claim.ruling == Ruling::holds) claim.ruling = Ruling::holds_within_limits;
  }
}

}  // namespace

void rule_on_polynomials(Claim& claim, const Evaluation& evaluation) {
  claim.evidence = "contenders";
  claim.criterion =
      "displacement error of method quadratic (24 functions) against exact, or finer where no closed form is known: at "
      "most 10 % for compact bodies, above 10 % for disparate ones, whose largest extent is more than 5 times the "
      "smallest; of one kind alone no more than within limits";
  const std::vector<Instance> quadratic = instances_of(evaluation, "quadratic");
  if (quadratic.empty()) return;
  claim.measured = "displacement error with linear and quadratic modes: ";
  conclude(claim, quadratic);
  limit_to_kinds_seen(claim, quadratic);
  const std::vector<Instance> linear = instances_of(evaluation, "linear");
  if (!linear.empty()) claim.measured += "; with linear modes alone: " + by_label(linear);
}

}  // namespace mb
