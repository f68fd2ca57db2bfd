// Settings of a study from the command line: --set KEY=VALUE[,VALUE...]. A case keeps its scene; what runs changes.
//
//   modal.methods, modal.modes                        of all reduced contenders
//   modal.integrators, modal.time_steps,              instead of the case's steppings: every method x mode count x
//     modal.relative_tolerances                       integrator x step or tolerance; "exact" is the closed form
//   rival.integrators, rival.degrees, rival.cells,    of all full-order contenders (cells as 1x4);
//     rival.time_steps, rival.relative_tolerances     rival.integrators=none: no full-order contender
//   study.analyses                                    "none": no analysis
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases/scene/read_toml.h"

namespace mb {

class Overrides {
 public:
  // assignments as given. Throws UsageError with every problem: unknown keys (with the nearest), words no catalogue
  // knows, numbers out of range.
  Overrides(const std::vector<std::string>& assignments, const Vocabulary& vocabulary);
  bool empty() const { return values_.empty(); }
  // Throws UsageError where an integrator is given no step or tolerance.
  Scene applied(Scene scene) const;

 private:
  const std::vector<std::string>* find(const std::string& key) const;
  std::vector<double> numbers(const std::string& key) const;
  std::vector<int> integers(const std::string& key) const;
  void apply_modal(Study& study) const;
  void apply_rivals(Study& study, const Shape& shape) const;

  std::map<std::string, std::vector<std::string>> values_;
  std::vector<std::string> adaptive_;
};

}  // namespace mb
