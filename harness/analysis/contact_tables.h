// Tables of the analyses `contact` and `contact-stiffness`; their columns stand in analyses.h.
#pragma once

#include <memory>
#include <vector>

#include "harness/analysis/contact_variants.h"

namespace mb {

// A contender with modes, of no step as yet, and what it is made of.
struct ContactBasis {
  ContactContender of;
  std::shared_ptr<const FloatingBases> bases;
};

Finding contact_meetings(const Scene& scene);
Finding contact_geometry(const std::vector<ContactBasis>& bases);
// What runs take, and of what; sampled as the scene asks for.
std::vector<Finding> contact_times(const std::vector<ContactBasis>& bases, const AnalysisContext& context);
// A contact of law hertz has no samples: then no rows.
Finding contact_samples(const ContactVariants& variants, const AnalysisContext& context);
// Contacts one by one, and how a small change of the layer's stiffness grows from one to the next.
std::vector<Finding> contact_conditions(const ContactVariants& variants, const AnalysisContext& context);
Finding force_history(const std::vector<ContactBasis>& bases, const AnalysisContext& context);

}  // namespace mb
