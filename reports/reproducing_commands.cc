#include "reports/verdict.h"

#include <algorithm>
#include <set>

#include "reports/environment.h"
#include "reports/words.h"

namespace mb {
namespace {

// Names from a store are untrusted, and readers paste commands into a shell: only plain words become part of one.
bool is_plain_word(const std::string& text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  };
  return !text.empty() && text.size() <= 64 && text[0] != '-' && std::all_of(text.begin(), text.end(), is_plain);
}

bool lists(const auto& values, const auto& value) { return std::ranges::find(values, value) != values.end(); }

// By the time step or tolerance that a table of the study lists: the other of the two is empty.
bool lists_accuracy(const auto& table, const Settings& settings) {
  return lists(table.time_steps, settings.time_step) ||
         (table.time_steps.empty() && lists(table.relative_tolerances, settings.relative_tolerance));
}

bool is_of_a_truth(const Scene& scene, const Contender& c) {
  const bool on_its_mesh = c.resolution == scene.truth.finer || c.resolution == own_meshes(scene);
  return c.method == "full-order" && c.integrator == "sundials" && on_its_mesh &&
         c.settings.relative_tolerance == scene.truth.relative_tolerance;
}

// Whether the case as its file has it runs this contender.
bool is_of_study(const Scene& scene, const Contender& c) {
  const auto at_modes = [&](const std::vector<int>& modes) {
    return !takes_modes(c) || lists(modes, c.settings.modes);
  };
  const auto is_stepped = [&](const Stepping& one) {
    return one.integrator == c.integrator && lists(one.methods, c.method) && at_modes(one.modes) &&
           lists_accuracy(one, c.settings);
  };
  const auto is_rival = [&](const Rival& one) {
    const bool own = one.cells.empty() && to_string(c.resolution) == to_string(own_meshes(scene));
    const bool its = lists(one.degrees, c.resolution.degree) && lists(one.cells, c.resolution.cells);
    return (own || its) && one.integrator == c.integrator && lists_accuracy(one, c.settings);
  };
  const Study& study = scene.study;
  if (c.method == "full-order") return std::ranges::any_of(study.rivals, is_rival) || is_of_a_truth(scene, c);
  if (c.integrator == "exact") return lists(study.methods, c.method) && at_modes(study.modes);
  return std::ranges::any_of(study.steppings, is_stepped);
}

// "  # does not repeat 3 runs of settings that the case file does not have (--set)"; "" where it repeats all.
std::string set_remark(const Evaluation& evaluation, const std::string& name, const std::string& profile) {
  const Scene* const scene = scene_of(evaluation, name, profile);
  if (!scene) return "";
  const auto n = std::ranges::count_if(evaluation.runs, [&](const Run& run) {
    return run.case_name == name && run.profile == profile && !is_of_study(*scene, run.contender);
  });
  if (n == 0) return "";
  return "  # does not repeat " + counted(static_cast<std::size_t>(n), "run", "runs") +
         " of settings that the case file does not have (--set)";
}

}  // namespace

std::vector<std::string> reproducing_commands(const Evaluation& evaluation) {
  std::vector<std::string> commands;
  const Commit commit = main_commit(evaluation);
  if (is_plain_word(commit.name)) {
    static const std::string changed = "-dirty";
    const bool dirty = commit.name.ends_with(changed);
    std::vector<std::string> remarks;
    if (dirty) remarks.push_back("and changes that were not committed");
    if (commit.n_others > 0) remarks.push_back("of " + std::to_string(commit.n_others) + " records another");
    const std::string name = commit.name.substr(0, commit.name.size() - (dirty ? changed.size() : 0));
    commands.push_back("git checkout " + name + (remarks.empty() ? "" : "  # " + joined(remarks, "; ")));
  }
  std::set<std::pair<std::string, std::string>> cases;
  for (const Record& record : evaluation.input.records) cases.insert({record.case_name, record.profile});
  for (const auto& [name, profile] : cases) {
    if (!is_plain_word(name) || !is_plain_word(profile)) continue;
    commands.push_back("modalbench run " + name + " --profile " + profile + set_remark(evaluation, name, profile));
  }
  commands.push_back("modalbench report");
  return commands;
}

}  // namespace mb
