// An analysis of a scene that a test makes, without a case file, a store and the program around it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "harness/analysis/analysis.h"

namespace mb::test {

template <class F>
auto in_context(const Scene& scene, const TruthSet& truth, F f) {
  const auto shared = std::make_shared<const Scene>(scene);
  const Catalogue catalogue = default_catalogue();
  std::unique_ptr<Model> model;
  return f(AnalysisContext{shared, catalogue, truth, [&](const Resolution& r) -> const Model& {
                             model = std::make_unique<Model>(make_model(shared, r));
                             return *model;
                           }});
}

inline std::vector<Finding> analysed(const std::string& name, const Scene& scene, const TruthSet& truth = {}) {
  return in_context(scene, truth, [&](const AnalysisContext& context) { return analysis(name).run(context); });
}

}  // namespace mb::test
