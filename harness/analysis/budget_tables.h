// The tables of the analysis `budget`, of scenes with loads and with contact alike; columns stand in analyses.h.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cases/contract/finding.h"
#include "harness/analysis/telescope.h"

namespace mb {

// Both norms of an answer at once. NaN of one that failed.
struct Normed {
  MatrixXd mass, energy;
};
std::shared_ptr<const Normed> in_both_norms(const Trajectory& answer, const MetricContext& context);

// An answer of the telescope, and what it does not simplify as the one before it does; none where it cannot be made.
struct BudgetLink {
  std::string name;                      // "truncation"; of the first answer ""
  std::shared_ptr<const Normed> answer;  // of the first and the last one always
};
// Without the answers that are missing: the links on both sides of them become one, "truncation + discretisation".
std::vector<BudgetLink> merged(const std::vector<BudgetLink>& chain);

struct BudgetOf {
  std::string body, method;
  double modes;  // NaN of a method that takes none
  std::string integrator, setting;
};

class BudgetTables {
 public:
  // answers: "modal in time steps, ...", they in words. exact_bar: [-] of the last one of all chains, relative to it,
  // where that is a closed form.
  explicit BudgetTables(const std::string& answers, std::optional<double> exact_bar = {});
  void add(const BudgetOf& of, const std::vector<BudgetLink>& chain);
  void note(const std::string& sentence) { parts_.note += " " + sentence; }
  std::vector<Finding> findings() && { return {std::move(parts_), std::move(cross_)}; }

 private:
  Finding parts_, cross_;
  std::optional<double> exact_bar_;
};

}  // namespace mb
