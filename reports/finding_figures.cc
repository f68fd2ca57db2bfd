#include "reports/figures.h"
#include "reports/finding_layers.h"

namespace mb {

std::vector<Figure> finding_figures(const Finding& finding) {
  std::vector<Figure> all;
  if (finding.name == "step-limits") all = step_limit_figures(finding);
  if (finding.name == "stability-map") all = stability_figures(finding);
  if (finding.name == "contact-stability" || finding.name == "corrected-stability")
    all = contact_stability_figures(finding);
  if (finding.name == "aliasing") all = aliasing_figures(finding);
  if (finding.name == "frequency-response") all = frequency_response_figures(finding);
  if (finding.name == "budget") all = budget_figures(finding);
  if (finding.name == "damping") all = damping_figures(finding);
  if (finding.name == "mode-amplitudes") all = amplitude_figures(finding);
  if (finding.name == "collision-cost") all = collision_figures(finding);
  if (finding.name == "contact-forces") all = contact_figures(finding);
  if (finding.name == "force-history") all = force_history_figures(finding);
  if (finding.name == "contact-time") all = contact_time_figures(finding);
  std::erase_if(all, [](const Figure& one) { return one.specification["data"]["values"].empty(); });
  for (Figure& one : all)  // after what tells figures of one finding apart
    one.specification["title"] =
        one.specification.value("title", std::string()) + finding.case_name + ", profile " + finding.profile;
  return all;
}

}  // namespace mb
