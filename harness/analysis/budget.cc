#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/reduced_answers.h"
#include "harness/analysis/telescope.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Finding parts_table(const char* truth) {
  return table(
      "budget", "budget", "Error budget: what each simplification costs",
      fmt::format("The error as a telescope of answers that differ in one respect: modal in time steps, modal in "
                  "closed form, full order on the same mesh, full order on the finer mesh{}. Norms over space and "
                  "time at the evaluation points, relative to the last: M norm of the deformation, each answer in "
                  "its own best rigid frame where the body is free; K norm of the strain. Parts add up as vectors: "
                  "total^2 is the sum of their squares and of the cross terms.",
                  truth),
      {{"method", ""},
       {"modes r", ""},
       {"integrator", ""},
       {"setting", ""},
       {"part", ""},
       {"M norm", "-"},
       {"K norm", "-"}});
}

Finding cross_table() {
  return table(
      "budget", "budget-cross-terms", "Error budget: cross terms",
      "2 <a, b> over the square of the truth's norm. Positive: both parts err the same way; negative: one hides "
      "part of the other.",
      {{"method", ""},
       {"modes r", ""},
       {"integrator", ""},
       {"setting", ""},
       {"parts", ""},
       {"M norm", "-"},
       {"K norm", "-"}});
}

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

// Both norms of an answer at once.
struct Normed {
  MatrixXd mass, energy;
};

class Budget {
 public:
  explicit Budget(const AnalysisContext& context)
      : context_(context),
        points_(evaluation_points(*context.scene, context.scene->bodies.front())),
        metric_{*context.scene, 0, points_, is_free(context)},
        full_({normed(context.truth.same_mesh), normed(context.truth.finer)}) {
    if (context.truth.exact) full_.push_back(normed(*context.truth.exact));
    parts_ = parts_table(context.truth.exact ? ", closed form of the continuum" : "");
    cross_ = cross_table();
  }

  void add(const Entry& entry, const ReducedAnswers& answers) {
    const std::string known = fmt::format("{} {}", entry.method, entry.settings.modes);
    if (closed_name_ != known) {
      closed_name_ = known;
      closed_ = normed(answers.answer(entry.method, context_.catalogue.integrator("exact"), entry.settings));
    }
    std::vector<Normed> chain;
    if (entry.integrator) chain.push_back(normed(answers.answer(entry.method, *entry.integrator, entry.settings)));
    chain.push_back(closed_);
    for (const Normed& answer : full_) chain.push_back(answer);
    add_rows(entry, chain);
  }
  std::vector<Finding> findings() && { return {std::move(parts_), std::move(cross_)}; }

 private:
  Normed normed(const Trajectory& answer) const {
    return {in_mass_norm(answer, metric_), in_energy_norm(answer, metric_)};
  }
  void add_rows(const Entry& entry, const std::vector<Normed>& chain);

  const AnalysisContext& context_;
  EvaluationPoints points_;
  MetricContext metric_;
  std::vector<Normed> full_;  // same mesh, finer, and the continuum where known
  std::string closed_name_;
  Normed closed_;  // the closed form of the method and mode count last asked for
  Finding parts_, cross_;
};

void Budget::add_rows(const Entry& entry, const std::vector<Normed>& chain) {
  std::vector<MatrixXd> mass, energy;
  for (const Normed& answer : chain) {
    mass.push_back(answer.mass);
    energy.push_back(answer.energy);
  }
  const Telescope M = telescope(mass), K = telescope(energy);
  std::vector<std::string> names{"truncation", "discretisation"};
  if (entry.integrator) names.insert(names.begin(), "time stepping");
  if (context_.truth.exact) names.push_back("finer mesh");
  const double r = context_.catalogue.method(entry.method).takes_modes() ? entry.settings.modes : nan;
  const std::string integrator = entry.integrator ? entry.integrator->name : "exact";
  const auto row = [&](const std::string& name, double m, double k) -> std::vector<FindingCell> {
    return {entry.method, r, integrator, entry.setting, name, m, k};
  };
  for (size_t i = 0; i < names.size(); ++i) {
    const auto a = static_cast<Index>(i);
    parts_.rows.push_back(row(names[i], M.parts(a), K.parts(a)));
    for (size_t j = i + 1; j < names.size(); ++j) {
      const auto b = static_cast<Index>(j);
      cross_.rows.push_back(row(names[i] + " x " + names[j], M.cross(a, b), K.cross(a, b)));
    }
  }
  parts_.rows.push_back(row("contact on the surface", nan, nan));
  parts_.rows.push_back(row("finite strain", nan, nan));
  parts_.rows.push_back(row("total", M.total, K.total));
}

}  // namespace

std::vector<Finding> error_budget(const AnalysisContext& context) {
  const std::vector<Entry> all = entries(context);
  int most = 0;
  for (const Entry& entry : all) most = std::max(most, entry.settings.modes);
  const ReducedAnswers answers(context, most);
  Budget budget(context);
  for (const Entry& entry : all) budget.add(entry, answers);
  return std::move(budget).findings();
}

}  // namespace mb
