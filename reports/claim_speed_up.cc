// C1, "up to two orders of magnitude": the largest speed-up of all cases decides, of the cheapest runs of both sides
// within the same error target. The full-order sweep is coarse: what exactly meets the target costs as much as its
// cheapest run within it or less, down to the dearest cheaper one, which is the near miss.
//
//   least >= 100 somewhere: holds,   ratio < 100 everywhere: does not hold,   else not decided
#include <algorithm>

#include "reports/claim_instances.h"
#include "reports/number.h"
#include "reports/speedup.h"
#include "reports/verdict.h"
#include "reports/words.h"

namespace mb {
namespace {

constexpr double two_orders = 100;  // [-]

std::string bounds(const SpeedUp& one) {
  return format_number(one.ratio) + " (at least " + format_number(least_ratio(one)) + ")";
}

std::string in_every_case(const std::vector<SpeedUp>& pairs) {
  std::vector<std::string> parts;
  for (const SpeedUp& one : pairs) parts.push_back(one.error.case_name + " " + bounds(one));
  return joined(parts, ", ");
}

// "no full-order run is within the target in 2 of 9 cases: a, b; rival at the edge of its sweep in c"
std::string limits_of_all(const std::vector<SpeedUp>& all) {
  const auto has_none = [](const SpeedUp& one) { return one.rival.empty(); };
  const std::string none = cases_where(all, has_none);
  std::string text = "no full-order run is within the target in " +
                     std::to_string(std::ranges::count_if(all, has_none)) + " of " +
                     counted(all.size(), "case", "cases");
  if (!none.empty()) text += ": " + none;
  const std::string edge = cases_where(all, stands_at_edge), perturbed = cases_where(all, has_perturbed_time);
  if (!edge.empty()) text += "; rival at the edge of its sweep in " + edge;
  return perturbed.empty() ? text : text + "; perturbed in " + perturbed;
}

}  // namespace

void rule_on_speed_up(Claim& claim, const Evaluation& evaluation) {
  claim.evidence = "speed-up";
  claim.criterion =
      "the largest speed-up of all cases, of the cheapest reduced run over the cheapest full-order run, both within "
      "1 % displacement error against exact, or finer where no closed form is known: at least 100 against the near "
      "miss, too, the dearest full-order run that is "
      "cheaper and outside; without cases of beam or plate theory, whose full-order runs are half waves, modes too";
  const std::vector<SpeedUp> all = at_target(evaluation, headline_metric);
  std::vector<SpeedUp> pairs = all;
  std::erase_if(pairs, [](const SpeedUp& one) { return one.rival.empty(); });
  claim.limits = joined({all.empty() ? "" : limits_of_all(all), theory_remark(evaluation)}, "; ");
  if (pairs.empty()) return;
  const auto less = [](const SpeedUp& a, const SpeedUp& b) { return a.ratio < b.ratio; };
  const SpeedUp& largest = *std::max_element(pairs.begin(), pairs.end(), less);
  const bool sure =
      std::any_of(pairs.begin(), pairs.end(), [](const auto& one) { return least_ratio(one) >= two_orders; });
  claim.ruling = sure ? Ruling::holds : largest.ratio < two_orders ? Ruling::does_not_hold : Ruling::not_decided;
  claim.measured = "largest speed-up " + bounds(largest) + " in " + largest.error.case_name + ", median " +
                   format_number(*median_ratio(pairs)) + "; by case: " + in_every_case(pairs);
}

}  // namespace mb
