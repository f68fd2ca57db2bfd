// What is found out about a case beyond the marks of single runs, each as tables (cases/contract/finding.h). A case
// names those it calls for in [study] analyses; nothing else is computed.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cases/contract/finding.h"
#include "harness/catalogue.h"
#include "harness/study/truth.h"

namespace mb {

struct AnalysisContext {
  std::shared_ptr<const Scene> scene;
  const Catalogue& catalogue;
  const TruthSet& truth;
  std::function<const Model&(const Resolution&)> model;  // one at a time: a reference is valid until the next call
};

struct Analysis {
  std::string name, doc;
  // Tables with analysis, name, title, note, columns, rows; who calls adds run, case, profile and provenance.
  std::vector<Finding> (*run)(const AnalysisContext& context);
  enum class Scenes { any, without_contact, with_contact } scenes = Scenes::any;  // for which it is made
  bool theories = false;      // whether bodies of beam and plate theory have it, too
  bool of_truth = false;      // told again of the truth's neighbour, for error bars (harness/analysis/told.h)
  bool of_mesh = false;       // told again of another mesh of the case, likewise
  bool timed = false;         // whether times are among its numbers: it runs alone
  bool single_modes = false;  // of modes one by one: not where a dashpot couples them
};

const std::vector<Analysis>& analysis_catalogue();
const Analysis& analysis(const std::string& name);  // throws std::out_of_range naming it

}  // namespace mb
