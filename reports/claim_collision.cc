// C11 compares an analytic shape with polygons tested one by one, which is what a tree of boxes was invented against:
// both kinds of rivals decide, so that the claim holds as far as its own rival goes.
#include "reports/claim_instances.h"

namespace mb {

void rule_on_collision(Claim& claim, const Evaluation& evaluation) {
  claim.evidence = "collision-cost";
  claim.criterion =
      "exponents of counted tests where points m and polygons n grow alike, claimed 1 for analytic and 2 for polygons, "
      "each within 0.15, and less time; against brute force and against a tree of boxes";
  const char* const table = "collision-cost-claim";
  const std::vector<Instance> rivals = rows_of(evaluation, claim.id, table, "against", "exponent rival");
  if (rivals.empty()) return;
  claim.measured =
      "exponent of tests, analytic: " + by_label(rows_of(evaluation, claim.id, table, "", "exponent analytic")) + "; ";
  conclude(claim, rivals);
}

}  // namespace mb
