#include "harness/catalogue.h"

#include <algorithm>
#include <stdexcept>

#include "harness/metrics/metric.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/newmark.h"
#include "modal/methods/methods.h"
#include "reference/full_order.h"
#include "reference/sundials.h"

namespace mb {

Catalogue default_catalogue() {
  return {{full_order(), eigenmodes(), static_correction()},
          {{"exact", "closed form of every mode on each segment of the load",
            [](const System& s, const Settings& set, double T) { return exact(s, T, set.load_tolerance); }},
           {"newmark", "average acceleration with a fixed step",
            [](const System& s, const Settings& set, double) { return newmark(s, set.time_step); }},
           {"sundials", "ARKODE, adaptive ESDIRK of order 5",
            [](const System& s, const Settings& set, double T) { return sundials(s, set.relative_tolerance, T); }}}};
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
  for (const auto& method : methods) names.methods.push_back(method->name());
  for (const auto& integrator : integrators) names.integrators.push_back(integrator.name);
  for (const Metric& metric : metric_catalogue()) names.metrics.push_back(metric.name);
  return names;
}

}  // namespace mb
