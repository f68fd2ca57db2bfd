#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/budget_tables.h"
#include "harness/analysis/contact_budget.h"
#include "harness/analysis/reduced_answers.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// One contender of the budget; without an integrator: in closed form.
struct Entry {
  std::string method;
  Settings settings;
  const Integrator* integrator;
  std::string setting;  // "dt = 0.001 s"
};

std::vector<double> ends(const std::vector<double>& values) {
  if (values.size() <= 2) return values;
  return {values.front(), values.back()};
}

std::vector<Entry> stepped(const AnalysisContext& context, const Stepping& stepping) {
  std::vector<Entry> entries;
  for (const std::string& name : stepping.methods) {
    const Method& method = context.catalogue.method(name);
    for (const int r : method.takes_modes() ? few(stepping.modes, 3) : std::vector{0}) {
      Entry entry{name, {}, &context.catalogue.integrator(stepping.integrator), ""};
      entry.settings.modes = r;
      entry.settings.load_tolerance = context.scene->study.load_tolerance;
      for (const double dt : ends(stepping.time_steps)) {
        entry.settings.time_step = dt;
        entry.setting = fmt::format("dt = {:.3g} s", dt);
        entries.push_back(entry);
      }
      for (const double tolerance : ends(stepping.relative_tolerances)) {
        entry.settings.relative_tolerance = tolerance;
        entry.setting = fmt::format("rtol = {:.0e}", tolerance);
        entries.push_back(entry);
      }
    }
  }
  return entries;
}

// The identity basis has nothing truncated, and no closed form at this size.
bool has_a_basis(const Entry& entry) { return entry.method != "full"; }

std::vector<Entry> entries(const AnalysisContext& context) {
  const Study& study = context.scene->study;
  std::vector<Entry> all;
  for (const Stepping& stepping : study.steppings)
    for (const Entry& entry : stepped(context, stepping)) all.push_back(entry);
  if (all.empty()) {
    for (const std::string& method : study.methods)
      for (const int r : context.catalogue.method(method).takes_modes() ? few(study.modes, 4) : std::vector{0}) {
        Entry entry{method, {}, nullptr, "closed form"};
        entry.settings.modes = r;
        entry.settings.load_tolerance = study.load_tolerance;
        all.push_back(entry);
      }
  }
  std::erase_if(all, [](const Entry& entry) { return !has_a_basis(entry); });
  return all;
}

std::string in_words(const AnalysisContext& context) {
  return fmt::format(
      "modal in time steps, modal in closed form, full order on the same mesh, full order on the finer "
      "mesh{}",
      context.truth.exact ? ", closed form of the continuum" : "");
}

std::optional<double> exact_bar(const AnalysisContext& context) {
  return context.truth.exact ? std::optional(context.truth.exact_bar) : std::nullopt;
}

class Budget {
 public:
  explicit Budget(const AnalysisContext& context)
      : context_(context),
        body_(context.scene->bodies.front()),
        points_(evaluation_points(*context.scene, body_)),
        metric_{*context.scene, 0, points_, is_free(context)},
        tables_(in_words(context), exact_bar(context)) {
    // Modes are of small strains, full order is not where the body is finite.
    const bool finite = body_.kinematics == Kinematics::finite;
    full_.push_back({finite ? "truncation + finite strain" : "truncation", normed(context.truth.same_mesh)});
    full_.push_back({"discretisation", normed(context.truth.finer)});
    if (context.truth.exact) full_.push_back({"finer mesh", normed(*context.truth.exact)});
  }

  void add(const Entry& entry, const ReducedAnswers& answers) {
    const std::string known = fmt::format("{} {}", entry.method, entry.settings.modes);
    if (closed_name_ != known) {
      closed_name_ = known;
      closed_ = normed(answers.answer(entry.method, context_.catalogue.integrator("exact"), entry.settings));
    }
    std::vector<BudgetLink> chain;
    if (entry.integrator)
      chain.push_back({"", normed(answers.answer(entry.method, *entry.integrator, entry.settings))});
    chain.push_back({entry.integrator ? "time stepping" : "", closed_});
    chain.insert(chain.end(), full_.begin(), full_.end());
    const double r = context_.catalogue.method(entry.method).takes_modes() ? entry.settings.modes : nan;
    tables_.add({body_.name, entry.method, r, entry.integrator ? entry.integrator->name : "exact", entry.setting},
                chain);
  }
  std::vector<Finding> findings() && { return std::move(tables_).findings(); }

 private:
  std::shared_ptr<const Normed> normed(const Trajectory& answer) const { return in_both_norms(answer, metric_); }

  const AnalysisContext& context_;
  const Body& body_;
  EvaluationPoints points_;
  MetricContext metric_;
  std::vector<BudgetLink> full_;  // same mesh, finer, and the continuum where known
  std::string closed_name_;
  std::shared_ptr<const Normed> closed_;  // the closed form of the method and mode count last asked for
  BudgetTables tables_;
};

}  // namespace

std::vector<Finding> error_budget(const AnalysisContext& context) {
  if (!context.scene->contacts.empty()) return contact_budget(context);
  const std::vector<Entry> all = entries(context);
  int most = 0;
  for (const Entry& entry : all) most = std::max(most, entry.settings.modes);
  const ReducedAnswers answers(context, most);
  Budget budget(context);
  for (const Entry& entry : all) budget.add(entry, answers);
  return std::move(budget).findings();
}

}  // namespace mb
