#include <fmt/ostream.h>

#include <memory>

#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/study/current_records.h"
#include "harness/study/identity.h"
#include "harness/study/run_case.h"
#include "reports/content.h"

namespace mb {

namespace {

std::vector<std::shared_ptr<const Scene>> scenes_of(const RunCommandOptions& options, const Catalogue& catalogue) {
  std::vector<std::filesystem::path> files;
  for (const auto& name : options.cases) files.push_back(find_case(name));
  if (options.cases.empty()) files = all_cases();
  std::vector<Diagnostic> problems;  // of all files at once
  std::vector<std::shared_ptr<const Scene>> scenes;
  for (const auto& file : files) try {
      scenes.push_back(std::make_shared<Scene>(read_toml(file, catalogue.vocabulary(), options.profile)));
    } catch (const CaseErrors& errors) {
      problems.insert(problems.end(), errors.diagnostics().begin(), errors.diagnostics().end());
    }
  if (!problems.empty()) throw CaseErrors(problems);
  if (scenes.empty()) throw UnknownCase("no case here: name a file, or run where a folder `cases` is");
  return scenes;
}

void print_plan(const Scene& scene, const Store& store, std::ostream& out) {
  for (const Contender& contender : contenders(scene)) {
    const std::string run = run_hash(scene, contender);
    fmt::print(out, "{}  {:<8} {} · {}\n", run, store.has_records(run) ? "stored" : "to run", scene.name,
               label(contender));
  }
}

// Prints every check of the scenes with what was measured; returns whether all hold.
bool print_checks(const std::vector<Scene>& scenes, const std::vector<Record>& records, std::ostream& out) {
  bool all = true;
  for (const CheckResult& result : check_results(scenes, records)) {
    const Check& check = result.check;
    const bool upper = check.at_most.has_value();
    fmt::print(out, "{:<5} {} · {} r={} · {} against {} = {} +- {:.1e} (must be {} {:g}){}\n",
               result.holds ? "holds" : "FAILS", result.case_name, check.method, check.modes, check.metric, check.truth,
               result.measured ? fmt::format("{:.3e}", result.value) : result.status, result.error_bar,
               upper ? "at most" : "at least", upper ? *check.at_most : *check.at_least,
               result.decidable ? "" : ": below the error bar, not decidable");
    all = all && result.holds;
  }
  return all;
}

}  // namespace

int run_command(const RunCommandOptions& options, const Catalogue& catalogue, const Console& console) {
  const auto scenes = scenes_of(options, catalogue);
  const Store store(options.store);
  if (options.plan) {
    for (const auto& scene : scenes) print_plan(*scene, store, console.out);
    return 0;
  }
  const Progress progress = [&](const std::string& line) {
    fmt::print(console.err, "{}\n", line), console.err.flush();
  };
  int n_failed = 0;
  bool interrupted = false;
  std::vector<Scene> finished;
  for (const auto& scene : scenes) try {
      const CaseOutcome outcome = run_case(scene, catalogue, store, {options.again, options.interrupted}, progress);
      fmt::print(console.err, "{} · {} runs done, {} found in {}, {} failed\n", scene->name, outcome.n_run,
                 outcome.n_stored, options.store, outcome.n_failed);
      n_failed += outcome.n_failed;
      finished.push_back(*scene);
      if ((interrupted = outcome.interrupted)) break;
    } catch (const StoreError&) {
      throw;  // concerns every case
    } catch (const std::exception& error) {
      fmt::print(console.err, "{} · failed: {}\n", scene->name, error.what());
      ++n_failed;
    }
  for (const RefusedLine& line : store.rebuild_results())
    fmt::print(console.err, "{}:{}: left out: {}\n", line.file.string(), line.line, line.reason);
  if (interrupted) {
    fmt::print(console.err, "interrupted; what is finished is kept. The same command goes on from here.\n");
    return 130;
  }
  const bool checks_hold = print_checks(finished, current_records(store, finished).records, console.out);
  return n_failed > 0 ? 3 : checks_hold ? 0 : 1;
}

}  // namespace mb
