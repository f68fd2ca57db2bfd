#include "harness/catalogue.h"

#include <algorithm>
#include <stdexcept>

#include "harness/analysis/analysis.h"
#include "harness/analysis/footings.h"
#include "harness/metrics/metric.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/system/central_difference.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/explicit_euler.h"
#include "mechanics/system/newmark.h"
#include "mechanics/system/symplectic_euler.h"
#include "modal/methods/methods.h"
#include "reference/full_order.h"
#include "reference/sundials/sundials.h"

namespace mb {

Catalogue default_catalogue() {
  using Knob = Integrator::Knob;
  return {
      {full_order(), eigenmodes(), static_correction(), linear_strain(), quadratic_strain(), full_basis()},
      {{"exact", "closed form of every mode on each segment of the load",
        [](const System& s, const Settings& set, double T) { return exact(s, T, set.load_tolerance); }, Knob::none},
       {"newmark", "average acceleration with a fixed step, one factor",
        [](const System& s, const Settings& set, double) { return newmark(s, set.time_step); }, Knob::time_step, false,
        [](const System& s, const std::vector<Contact>& c, const Settings& set, double) {
          return newmark(s, c, set.time_step);
        }},
       {"central-difference", "explicit central differences; on a mesh with the mass lumped",
        [](const System& s, const Settings& set, double) { return central_difference(s, set.time_step); },
        Knob::time_step, true,
        [](const System& s, const std::vector<Contact>& c, const Settings& set, double) {
          return central_difference(s, c, set.time_step);
        }},
       {"explicit-euler", "explicit Euler, the one the paper names",
        [](const System& s, const Settings& set, double) { return explicit_euler(s, set.time_step); }, Knob::time_step,
        true,
        [](const System& s, const std::vector<Contact>& c, const Settings& set, double) {
          return explicit_euler(s, c, set.time_step);
        }},
       {"symplectic-euler", "symplectic (semi-implicit) Euler",
        [](const System& s, const Settings& set, double) { return symplectic_euler(s, set.time_step); },
        Knob::time_step, true,
        [](const System& s, const std::vector<Contact>& c, const Settings& set, double) {
          return symplectic_euler(s, c, set.time_step);
        }},
       {"sundials", "ARKODE, adaptive ESDIRK of order 5",
        [](const System& s, const Settings& set, double T) { return sundials(s, set.relative_tolerance, T); },
        Knob::tolerance, false,
        [](const System& s, const std::vector<Contact>& c, const Settings& set, double T) {
          return sundials(s, c, set.relative_tolerance, T);
        }}}};
}

const Method& Catalogue::method(const std::string& name) const {
  const auto it = std::find_if(methods.begin(), methods.end(), [&](const auto& m) { return m->name() == name; });
  if (it == methods.end()) throw std::out_of_range("no method '" + name + "' in the catalogue");
  return **it;
}

const Integrator& Catalogue::integrator(const std::string& name) const {
  const auto it = std::find_if(integrators.begin(), integrators.end(), [&](const auto& i) { return i.name == name; });
  if (it == integrators.end()) throw std::out_of_range("no integrator '" + name + "' in the catalogue");
  return *it;
}

Vocabulary Catalogue::vocabulary() const {
  Vocabulary names;
  for (const auto& method : methods) {
    names.methods.push_back(method->name());
    if (!method->takes_modes()) names.methods_without_modes.push_back(method->name());
  }
  for (const auto& integrator : integrators) {
    names.integrators.push_back(integrator.name);
    if (integrator.knob == Integrator::Knob::tolerance) names.adaptive_integrators.push_back(integrator.name);
    if (integrator.prepare_in_contact) names.impact_integrators.push_back(integrator.name);
  }
  for (const Metric& metric : metric_catalogue()) {
    names.metrics.push_back(metric.name);
    const bool of_one = metric.of_truth_alone || metric.of_answer_alone;
    if (!of_one && !metric.contact_only) names.metrics_of_steps.push_back(metric.name);
  }
  for (const Analysis& analysis : analysis_catalogue()) {
    names.analyses.push_back(analysis.name);
    if (analysis.scenes == Analysis::Scenes::without_contact) names.analyses_of_loads.push_back(analysis.name);
    if (analysis.scenes == Analysis::Scenes::with_contact) names.analyses_of_contact.push_back(analysis.name);
    if (analysis.single_modes) names.analyses_of_single_modes.push_back(analysis.name);
    if (analysis.theories) names.analyses_of_theories.push_back(analysis.name);
  }
  names.tables = analyses_of_tables();
  return names;
}

}  // namespace mb
