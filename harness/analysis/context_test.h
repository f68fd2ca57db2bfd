// An analysis of a scene that a test makes, without a case file, a store and the program around it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "harness/analysis/analysis.h"

namespace mb::test {

inline std::vector<Finding> analysed(const std::string& name, const Scene& scene, const TruthSet& truth = {}) {
  const auto shared = std::make_shared<const Scene>(scene);
  const Catalogue catalogue = default_catalogue();
  std::unique_ptr<Model> model;
  return analysis(name).run({shared, catalogue, truth, [&](const Resolution& r) -> const Model& {
                               model = std::make_unique<Model>(make_model(shared, r));
                               return *model;
                             }});
}

}  // namespace mb::test
