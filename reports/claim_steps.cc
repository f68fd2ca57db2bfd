// C6, of the schemes that integrators of the catalogue step by. Others stand in the tables for comparison alone.
#include <algorithm>

#include "reports/claim_instances.h"
#include "reports/findings.h"

namespace mb {
namespace {

bool is_of_no_integrator(const Evaluation& evaluation, const Instance& one) {
  for (const Finding& finding : evaluation.input.findings) {
    if (finding.name != "step-limits" || finding.case_name != one.where) continue;
    for (std::size_t i = 0; i < finding.rows.size(); ++i) {
      if (text_at(finding, i, "scheme") == one.label && text_at(finding, i, "integrator") == "none") return true;
    }
  }
  return false;
}

}  // namespace

void rule_on_steps(Claim& claim, const Evaluation& evaluation) {
  claim.evidence = "step-limits";
  claim.criterion =
      "exponent of the measured limit over omega, a scheme each, claimed -1; schemes of no integrator here do not "
      "decide";
  std::vector<Instance> all = rows_of(evaluation, claim.id, "step-limit-exponents", "scheme", "exponent");
  for (Instance& one : all) one.decides = !is_of_no_integrator(evaluation, one);
  conclude(claim, all);
}

}  // namespace mb
