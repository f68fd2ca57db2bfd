// Formula and source of each method, integrator and analysis, for `modalbench explain`. A contender from elsewhere has
// none here and is explained by its own doc.
#pragma once

#include <string>

namespace mb {

struct FormulaAndSource {
  std::string formula, source;  // plain text
};
FormulaAndSource formula_of(const std::string& name);  // empty texts for a name that is not known

}  // namespace mb
