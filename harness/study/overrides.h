// Settings of a study from the command line: --set KEY=VALUE[,VALUE...]. A case keeps its scene; what runs changes.
//
//   modal.methods, modal.modes, modal.contact_steps   of all reduced contenders; steps while they touch
//   modal.integrators, modal.time_steps,              instead of the case's steppings: every method x mode count x
//     modal.relative_tolerances                       integrator x step or tolerance; "exact" is the closed form
//   rival.integrators, rival.degrees, rival.cells,    of all full-order contenders (cells as 1x4);
//     rival.time_steps, rival.relative_tolerances     rival.integrators=none: no full-order contender
//   study.analyses                                    "none": no analysis
//
// The case's [study] with these values in it goes through the reader of case files: its limits hold here, too.
#pragma once

#include <string>
#include <vector>

#include "cases/scene/read_toml.h"
#include "harness/study/assignments.h"

namespace mb {

const std::vector<std::string>& set_keys();  // as above

class Overrides {
 public:
  // assignments as given. Throws CaseErrors with every key that is unknown or given twice.
  Overrides(const std::vector<std::string>& assignments, const Vocabulary& vocabulary);
  bool empty() const { return assignments_.values.empty(); }
  // Throws CaseErrors with every value that the reader would refuse in this case, and where an integrator is given no
  // step or tolerance, or twice. What the case itself states and is wrong beside one is shown at that.
  Scene applied(Scene scene) const;

 private:
  Assignments assignments_;
  Vocabulary vocabulary_;
};

}  // namespace mb
