#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "cases/json/json.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/study/current_records.h"
#include "harness/study/overrides.h"
#include "harness/study/processes.h"
#include "harness/study/run_case.h"
#include "reports/content.h"

namespace mb {

namespace {

using Scenes = std::vector<std::shared_ptr<const Scene>>;

Scenes scenes_of(const RunCommandOptions& options, const Catalogue& catalogue) {
  const Overrides overrides(options.overrides, catalogue.vocabulary());
  std::vector<std::filesystem::path> files;
  for (const auto& name : options.cases) files.push_back(find_case(name));
  if (options.cases.empty()) files = all_cases();
  std::vector<Diagnostic> problems;  // of all files at once
  Scenes scenes;
  for (const auto& file : files) try {
      scenes.push_back(
          std::make_shared<Scene>(overrides.applied(read_toml(file, catalogue.vocabulary(), options.profile))));
    } catch (const CaseErrors& errors) {
      problems.insert(problems.end(), errors.diagnostics().begin(), errors.diagnostics().end());
    }
  if (!problems.empty()) throw CaseErrors(problems);
  // Named cases run in any profile.
  if (options.cases.empty())
    std::erase_if(scenes, [&](const auto& scene) { return std::ranges::count(scene->runs_in, options.profile) == 0; });
  if (scenes.empty()) throw UnknownCase("no case here: name a file, or run where a folder `cases` is");
  return scenes;
}

bool is_stored(const Job& job, const Store& store) {
  return job.kind == Job::Kind::analysis ? store.has_findings(job.hash) : store.has_records(job.hash);
}

Json plan_json(const Scene& scene, const Job& job, bool stored) {
  Json json = {{"run", job.hash},          {"case", scene.name},
               {"profile", scene.profile}, {"kind", job.kind == Job::Kind::marks ? "marks" : "analysis"},
               {"label", job.label},       {"stored", stored}};
  if (job.kind == Job::Kind::marks) {
    json["method"] = job.contender.method;
    json["integrator"] = job.contender.integrator;
    json["resolution"] = to_string(job.contender.resolution);
  }
  return json;
}

void print_plan(const Scenes& scenes, const Catalogue& catalogue, const Store& store, const Shard& shard, bool json,
                std::ostream& out) {
  Json list = Json::array();
  for (const auto& scene : scenes)
    for (const Job& job : part(jobs(*scene, catalogue), shard)) {
      const bool stored = is_stored(job, store);
      if (json)
        list.push_back(plan_json(*scene, job, stored));
      else
        fmt::print(out, "{}  {:<8} {} · {}\n", job.hash, stored ? "stored" : "to run", scene->name, job.label);
    }
  if (json) fmt::print(out, "{}\n", to_line({{"schema", 1}, {"jobs", list}}));
}

// Prints every check of the scenes with what was measured; returns whether all hold. Where --set chose what ran, a
// check of what did not run is no failure.
bool print_checks(const std::vector<Scene>& scenes, const StoredResults& stored, bool all_ran, std::ostream& out) {
  bool all = true;
  for (const CheckResult& result : check_results(scenes, stored.records, stored.findings)) {
    const Check& check = result.check;
    if (!all_ran && result.status == "no record") continue;
    const bool upper = check.at_most.has_value();
    const std::string of = check.table.empty() ? fmt::format("{} r={} · {} against {}", check.method, check.modes,
                                                             check.metric, check.truth)
                                               : subject_of(check);
    fmt::print(out, "{:<5} {} · {} = {} +- {:.1e} (must be {} {:g}){}\n", result.holds ? "holds" : "FAILS",
               result.case_name, of, result.measured ? fmt::format("{:.3e}", result.value) : result.status,
               result.error_bar, upper ? "at most" : "at least", upper ? *check.at_most : *check.at_least,
               result.decidable ? "" : ": below the error bar, not decidable");
    all = all && result.holds;
  }
  return all;
}

struct Outcome {
  int n_failed = 0;
  bool interrupted = false;
  std::vector<Scene> finished;
};

Outcome run_all(const Scenes& scenes, const Catalogue& catalogue, const Store& store, const RunOptions& options,
                const Console& console) {
  const Progress progress = [&](const std::string& line) {
    fmt::print(console.err, "{}\n", line), console.err.flush();
  };
  Outcome outcome;
  for (const auto& scene : scenes) try {
      const CaseOutcome one = run_case(scene, catalogue, store, options, progress);
      fmt::print(console.err, "{} · {} runs done, {} found in {}, {} failed\n", scene->name, one.n_run, one.n_stored,
                 store.directory().string(), one.n_failed);
      outcome.n_failed += one.n_failed;
      outcome.finished.push_back(*scene);
      if ((outcome.interrupted = one.interrupted)) break;
    } catch (const StoreError&) {
      throw;  // concerns every case
    } catch (const std::exception& error) {
      fmt::print(console.err, "{} · failed: {}\n", scene->name, error.what());
      ++outcome.n_failed;
    }
  return outcome;
}

// Marks and tables by several processes; what they fail at is run again by who calls, and counted there. Computes
// nothing itself before the last of them has ended.
void run_in_parallel(const Scenes& scenes, const Catalogue& catalogue, const Store& store, const RunOptions& options,
                     int n, const Console& console) {
  for (const auto& scene : scenes) {
    if (options.interrupted && options.interrupted()) return;
    RunOptions shared = options;
    shared.timed = false;
    const auto progress = [&](const std::string& line) { fmt::print(console.err, "{}\n", line), console.err.flush(); };
    if (all_stored(*scene, catalogue, store)) continue;
    // Truths first, in a process of their own: threads that libraries start there would not survive a fork.
    const int code = in_processes(1, [&](int) { return truths(scene, catalogue, store, progress), 0; });
    if (code != 0) continue;  // the caller meets and names what failed
    in_processes(n, [&](int i) {
      shared.shard = {i, n};
      return run_all({scene}, catalogue, store, shared, console).n_failed > 0 ? 3 : 0;
    });
  }
}

std::string command_again(const RunCommandOptions& options) {
  std::string text = "modalbench run";
  for (const auto& name : options.cases) text += " " + name;
  if (options.profile != "quick") text += " --profile " + options.profile;
  if (options.store != "results") text += " --store " + options.store;
  for (const auto& assignment : options.overrides) text += " --set " + assignment;
  if (options.shard != "1/1") text += " --shard " + options.shard;
  if (options.jobs != 1) text += fmt::format(" --jobs {}", options.jobs);
  return text + (options.untimed ? " --untimed" : "");
}

}  // namespace

int run_command(const RunCommandOptions& options, const Catalogue& catalogue, const Console& console) {
  const auto shard = parse_shard(options.shard);
  if (!shard) throw UsageError("--shard " + options.shard + ": must be i/n with 1 <= i <= n, as 2/8");
  const Scenes scenes = scenes_of(options, catalogue);
  const Store store(options.store);
  if (options.plan) {
    print_plan(scenes, catalogue, store, *shard, options.json, console.out);
    return 0;
  }
  RunOptions how{options.again, !options.untimed, *shard, options.interrupted};
  if (options.jobs > 1 && shard->whole()) {
    run_in_parallel(scenes, catalogue, store, how, options.jobs, console);
    how.again = false;
  }
  const Outcome outcome = run_all(scenes, catalogue, store, how, console);
  for (const RefusedLine& line : store.rebuild_results())
    fmt::print(console.err, "{}:{}: left out: {}\n", line.file.string(), line.line, line.reason);
  if (outcome.interrupted) {
    fmt::print(console.err, "interrupted; what is finished is kept. To go on:\n  {}\n", command_again(options));
    return 130;
  }
  if (!shard->whole()) return outcome.n_failed > 0 ? 3 : 0;  // checks are of the whole
  const StoredResults stored = current_records(store, outcome.finished);
  const bool checks_hold = print_checks(outcome.finished, stored, options.overrides.empty(), console.out);
  return outcome.n_failed > 0 ? 3 : checks_hold ? 0 : 1;
}

}  // namespace mb
