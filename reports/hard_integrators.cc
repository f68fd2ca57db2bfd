#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "cases/contract/status.h"
#include "reports/hard_cases.h"
#include "reports/words.h"

namespace mb {
namespace {

constexpr std::array integrators{"exact",          "newmark", "central-difference", "symplectic-euler",
                                 "explicit-euler", "sundials"};
constexpr std::array systems{"full order", "modes"};

struct Tried {
  std::set<std::string> runs, unstable_runs;
  std::size_t n_cells = 0, n_unstable_cells = 0, n_beside_limits = 0;
};
using TriedBy = std::map<std::pair<std::string, std::string>, Tried>;  // system, integrator

void count_runs(const std::vector<Record>& records, const Scene& scene, TriedBy& tried) {
  for (const Record& record : records) {
    if (record.case_name != scene.name || record.profile != scene.profile) continue;
    const char* const system = record.contender.method == "full-order" ? "full order" : "modes";
    Tried& one = tried[{system, record.contender.integrator}];
    one.runs.insert(record.run);
    if (is_unstable(record.status)) one.unstable_runs.insert(record.run);
  }
}

std::string text_of(const Finding& table, const std::vector<FindingCell>& row, const std::string& column) {
  const auto at = std::ranges::find(table.columns, column, &FindingColumn::name);
  if (at == table.columns.end()) return "";
  const FindingCell& cell = row.at(static_cast<std::size_t>(at - table.columns.begin()));
  return cell.index() == 0 ? std::get<std::string>(cell) : "";
}

void count_cells(const std::vector<Finding>& findings, const Scene& scene, TriedBy& tried) {
  static const std::set<std::string> maps{"stability-map", "contact-stability", "corrected-stability"};
  for (const Finding& table : findings) {
    const bool is_map = maps.contains(table.name);
    if (table.case_name != scene.name || table.profile != scene.profile) continue;
    if (!is_map && table.name != "step-limit-runs") continue;
    for (const auto& row : table.rows) {
      const std::string system = text_of(table, row, "system");
      Tried& one = tried[{system.starts_with("full") ? "full order" : "modes", text_of(table, row, "integrator")}];
      one.n_beside_limits += !is_map;
      one.n_cells += is_map;
      one.n_unstable_cells += is_map && text_of(table, row, "found") == "unstable";
    }
  }
}

std::string with_unstable(std::size_t n, const char* one, const char* more, std::size_t n_unstable) {
  return counted(n, one, more) + (n_unstable > 0 ? ", " + std::to_string(n_unstable) + " unstable" : "");
}

std::string words_of(const Tried& tried) {
  std::vector<std::string> words;
  if (!tried.runs.empty()) words.push_back(with_unstable(tried.runs.size(), "run", "runs", tried.unstable_runs.size()));
  if (tried.n_cells > 0)
    words.push_back("map of " + with_unstable(tried.n_cells, "cell", "cells", tried.n_unstable_cells));
  if (tried.n_beside_limits > 0) words.push_back(std::to_string(tried.n_beside_limits) + " beside limits");
  return words.empty() ? "none" : joined(words, "; ");
}

}  // namespace

Sheet hard_integrators_table(const Evaluation& evaluation) {
  Sheet table{.name = "hard-integrators",
              .title = "Integrators of hard cases",
              .note =
                  "What each hard case went through: runs, cells of its stability maps over step, mode count and "
                  "stiffness of contact, and runs at 0.99 and 1.01 of the limit of the step. Exact: closed form, "
                  "of contact kicks between closed forms.",
              .columns = {{"case", ""}, {"profile", ""}, {"system", ""}},
              .rows = {},
              .n_keys = 0};
  for (const char* integrator : integrators) table.columns.push_back({integrator, ""});
  for (const Scene& scene : evaluation.input.scenes) {
    if (scene.hard.empty()) continue;
    TriedBy tried;
    count_runs(evaluation.input.records, scene, tried);
    count_cells(evaluation.input.findings, scene, tried);
    for (const char* system : systems) {
      table.rows.push_back({text_cell(scene.name), text_cell(scene.profile), text_cell(system)});
      for (const char* integrator : integrators)
        table.rows.back().push_back(text_cell(words_of(tried[{system, integrator}])));
    }
  }
  return table;
}

}  // namespace mb
