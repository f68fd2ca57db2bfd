#include "harness/analysis/budget_tables.h"

#include <fmt/format.h>

#include <limits>

#include "harness/analysis/modal_body.h"

namespace mb {

namespace {

Finding parts_table(const std::string& answers) {
  return table("budget", "budget", "Error budget: what each simplification costs",
               fmt::format("The error as a telescope of answers that differ in one respect: {}. Norms over space and "
                           "time at the evaluation points, relative to the last: M norm of the deformation, each "
                           "answer in its own best rigid frame where the body is free; K norm of the strain. Parts add "
                           "up as vectors: total^2 is the sum of their squares and of the cross terms.",
                           answers),
               {{"body", ""},
                {"method", ""},
                {"modes r", ""},
                {"integrator", ""},
                {"setting", ""},
                {"part", ""},
                {"M norm", "-"},
                {"K norm", "-"}});
}

Finding cross_table() {
  return table("budget", "budget-cross-terms", "Error budget: cross terms",
               "2 <a, b> over the square of the truth's norm. Positive: both parts err the same way; negative: one "
               "hides part of the other.",
               {{"body", ""},
                {"method", ""},
                {"modes r", ""},
                {"integrator", ""},
                {"setting", ""},
                {"parts", ""},
                {"M norm", "-"},
                {"K norm", "-"}});
}

}  // namespace

std::shared_ptr<const Normed> in_both_norms(const Trajectory& answer, const MetricContext& context) {
  auto both = std::make_shared<Normed>(in_mass_norm(answer, context), in_energy_norm(answer, context));
  if (answer.status == Status::ok) return both;
  both->mass.setConstant(std::numeric_limits<double>::quiet_NaN());
  both->energy.setConstant(std::numeric_limits<double>::quiet_NaN());
  return both;
}

std::vector<BudgetLink> merged(const std::vector<BudgetLink>& chain) {
  std::vector<BudgetLink> all;
  std::string waiting;
  for (const BudgetLink& link : chain) {
    waiting += waiting.empty() ? link.name : " + " + link.name;
    if (!link.answer) continue;
    all.push_back({waiting, link.answer});
    waiting.clear();
  }
  return all;
}

BudgetTables::BudgetTables(const std::string& answers, std::optional<double> exact_bar)
    : parts_(parts_table(answers)), cross_(cross_table()), exact_bar_(exact_bar) {
  if (exact_bar) parts_.note += " Bars of what is told against the closed form: at least that of its series.";
}

void BudgetTables::add(const BudgetOf& of, const std::vector<BudgetLink>& chain) {
  const std::vector<BudgetLink> links = merged(chain);
  Chain mass, energy;
  for (const BudgetLink& link : links) {
    mass.emplace_back(link.answer->mass);
    energy.emplace_back(link.answer->energy);
  }
  const Telescope M = telescope(mass), K = telescope(energy);
  const auto row = [&](const std::string& name, double m, double k) -> std::vector<FindingCell> {
    return {of.body, of.method, of.modes, of.integrator, of.setting, name, m, k};
  };
  for (Index a = 0; a < M.parts.size(); ++a) {
    const std::string& name = links[static_cast<size_t>(a) + 1].name;
    parts_.rows.push_back(row(name, M.parts(a), K.parts(a)));
    if (exact_bar_ && a + 1 == M.parts.size()) bar_last_row(parts_, {{"M norm", *exact_bar_}, {"K norm", *exact_bar_}});
    for (Index b = a + 1; b < M.parts.size(); ++b)
      cross_.rows.push_back(row(name + " x " + links[static_cast<size_t>(b) + 1].name, M.cross(a, b), K.cross(a, b)));
  }
  parts_.rows.push_back(row("total", M.total, K.total));
  if (exact_bar_) bar_last_row(parts_, {{"M norm", *exact_bar_}, {"K norm", *exact_bar_}});
}

}  // namespace mb
