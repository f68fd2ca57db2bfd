// C12 speaks of contact regions known analytically: their closed form by curvatures, and quadrature within them. As
// many points spread over the whole exact surface know no region, and stand beside these to tell what is due to it.
#include "reports/claim_instances.h"

namespace mb {

void rule_on_contact(Claim& claim, const Evaluation& evaluation) {
  claim.evidence = "contact-forces";
  claim.criterion =
      "error of vertices over that of the analytic contender, of force, Hertz's force and impulse at every depth and "
      "number of samples, claimed above 1; uniform quadrature does not decide";
  std::vector<Instance> all = rows_of(evaluation, claim.id, "contact-forces-claim", "compared", "gain");
  if (all.empty()) return;
  for (Instance& one : all) one.decides = one.label.find("quadrature, uniform") == std::string::npos;
  claim.measured = "error of vertices over that of analytic contact: ";
  conclude(claim, all);
}

}  // namespace mb
