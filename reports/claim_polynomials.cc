// C4 has two halves: rigid, linear and quadratic modes suffice for compact bodies, and do not for disparate ones. The
// claim is about scenes of many bodies, which meet: the first half goes by compact bodies in contact where there are
// any, and what they do under smooth loads, and bars over slenderness, can but limit it. The second goes by all.
//
//   compact ones fail -> does not hold;   both halves hold -> holds;   else within limits
#include <algorithm>
#include <cmath>

#include "reports/claim_instances.h"
#include "reports/findings.h"
#include "reports/number.h"
#include "reports/polynomial_modes.h"

namespace mb {
namespace {

bool is_compact(const Instance& one) { return one.label.starts_with("compact"); }
bool is_in_contact(const Instance& one) { return one.label.ends_with("in contact"); }

// Supports the claim where it suffices and is compact, or does not and is disparate.
Ruling ruling_of(std::optional<bool> enough, bool compact) {
  if (!enough) return Ruling::not_decided;
  return *enough == compact ? Ruling::holds : Ruling::does_not_hold;
}

std::vector<Instance> of_scenes(const Evaluation& evaluation, const std::string& method) {
  std::vector<Instance> all;
  for (const PolynomialMark& mark : polynomial_marks(evaluation))
    if (mark.method == method)
      all.push_back({mark.case_name, kind(mark), worst_error(mark), ruling_of(suffices(mark), mark.compact())});
  return all;
}

// Of tables `slenderness`, by the degree of polynomials; a row a load and length.
std::vector<Instance> over_slenderness(const Evaluation& evaluation, double degree) {
  std::vector<Instance> all;
  for (const Finding& finding : evaluation.input.findings) {
    if (finding.name != "slenderness") continue;
    for (std::size_t i = 0; i < finding.rows.size(); ++i) {
      if (number_at(finding, i, "degree") != degree) continue;
      const double ratio = number_at(finding, i, "length/width"), error = number_at(finding, i, "displacement error");
      if (std::isnan(ratio) || std::isnan(error)) continue;
      const double bar = number_at(finding, i, "bar");
      const bool compact = ratio <= most_compact, within = error + bar <= still_suffices;
      const std::optional<bool> enough = within || error - bar > still_suffices ? std::optional(within) : std::nullopt;
      all.push_back({finding.case_name + ": " + text_at(finding, i, "load") + " at " + format_setting(ratio),
                     compact ? "compact, under loads" : "disparate, under loads", error, ruling_of(enough, compact)});
    }
  }
  return all;
}

using Instances = std::vector<Instance>;
template <class Test>
Ruling together_of(const Instances& all, const Test& counts) {
  std::vector<Ruling> rulings;
  for (const Instance& one : all)
    if (counts(one)) rulings.push_back(one.ruling);
  return together(rulings);
}

Ruling on_compact(const Instances& all) {
  const Ruling meeting = together_of(all, [](const Instance& one) { return is_compact(one) && is_in_contact(one); });
  const Ruling loaded = together_of(all, [](const Instance& one) { return is_compact(one) && !is_in_contact(one); });
  if (meeting == Ruling::not_measured) return loaded;
  const bool limited = loaded == Ruling::does_not_hold || loaded == Ruling::holds_within_limits;
  return meeting == Ruling::holds && limited ? Ruling::holds_within_limits : meeting;
}

Ruling on_both(Ruling compact, Ruling disparate) {
  if (compact == Ruling::not_measured) return disparate == Ruling::holds ? Ruling::holds_within_limits : disparate;
  if (compact == Ruling::does_not_hold || compact == Ruling::not_decided) return compact;
  return compact == Ruling::holds && disparate == Ruling::holds ? Ruling::holds : Ruling::holds_within_limits;
}

// "compact, in contact: 0.700 to 1.50, at most 10 % in 0 of 6"
std::string by_kind(const Instances& all) {
  std::string text;
  for (const char* of :
       {"compact, in contact", "compact, under loads", "disparate, in contact", "disparate, under loads"}) {
    Instances these;
    std::ranges::copy_if(all, std::back_inserter(these), [&](const Instance& one) { return one.label == of; });
    if (these.empty()) continue;
    const auto n = std::ranges::count_if(these, [](const Instance& one) {
      return one.ruling == (is_compact(one) ? Ruling::holds : Ruling::does_not_hold);
    });
    text += (text.empty() ? "" : "; ") + by_label(these) + ", at most 10 % in " + std::to_string(n) + " of " +
            std::to_string(these.size());
  }
  return text;
}

void limit_to_kinds_seen(Claim& claim, const Instances& instances) {
  for (const bool compact : {true, false}) {
    if (std::ranges::any_of(instances, [&](const Instance& one) { return is_compact(one) == compact; })) continue;
    claim.limits +=
        (claim.limits.empty() ? "" : "; ") + std::string(compact ? "compact" : "disparate") + " bodies: not measured";
  }
}

}  // namespace

void rule_on_polynomials(Claim& claim, const Evaluation& evaluation) {
  claim.evidence = "polynomial-modes";
  claim.criterion =
      "displacement error, in contact also peak force and impulse, of method quadratic (24 functions) against exact, "
      "or finer where no closed form is known, the largest of them at most 10 %: claimed of compact bodies, not of "
      "disparate ones, whose largest extent is more than 5 times the smallest. Compact bodies decide in contact where "
      "there are such, since bodies of a scene meet: where none of them is within 10 % the claim does not hold. Bars "
      "of slenderness 1 to 50 count as bodies under loads";
  Instances all = of_scenes(evaluation, "quadratic");
  const Instances bars = over_slenderness(evaluation, 2);
  all.insert(all.end(), bars.begin(), bars.end());
  if (all.empty()) return;
  claim.ruling = on_both(on_compact(all), together_of(all, [](const Instance& one) { return !is_compact(one); }));
  claim.measured = "largest error with linear and quadratic modes: " + by_kind(all);
  claim.limits = limits(all);
  limit_to_kinds_seen(claim, all);
  Instances linear = of_scenes(evaluation, "linear");
  const Instances linear_bars = over_slenderness(evaluation, 1);
  linear.insert(linear.end(), linear_bars.begin(), linear_bars.end());
  if (!linear.empty()) claim.measured += "; with linear modes alone: " + by_label(linear);
}

}  // namespace mb
