#include <fmt/ostream.h>

#include <algorithm>
#include <memory>

#include "cases/scene/printable.h"
#include "harness/commands/command_again.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/commands/plan_table.h"
#include "harness/study/current_records.h"
#include "harness/study/estimate.h"
#include "harness/study/memory.h"
#include "harness/study/overrides.h"
#include "harness/study/processes.h"
#include "harness/study/run_case.h"
#include "harness/study/stored.h"
#include "mechanics/algebra/threads.h"
#include "reports/content.h"
#include "reports/warnings.h"

namespace mb {

namespace {

using Scenes = std::vector<std::shared_ptr<const Scene>>;

Scenes scenes_of(const RunCommandOptions& options, const Catalogue& catalogue) {
  const Overrides overrides(options.overrides, catalogue.vocabulary());
  const auto files = options.cases.empty() ? all_cases() : find_cases(options.cases);
  std::vector<Diagnostic> problems;  // of all files at once
  Scenes scenes;
  NamedFiles named;
  for (const auto& file : files) try {
      scenes.push_back(
          std::make_shared<Scene>(overrides.applied(read_toml(file, catalogue.vocabulary(), options.profile))));
      named.emplace_back(scenes.back()->name, file);
    } catch (const CaseErrors& errors) {
      problems.insert(problems.end(), errors.diagnostics().begin(), errors.diagnostics().end());
    }
  if (!problems.empty()) throw CaseErrors(problems);
  require_names_of_their_own(named);
  // Named cases run in any profile.
  if (options.cases.empty())
    std::erase_if(scenes, [&](const auto& scene) { return std::ranges::count(scene->runs_in, options.profile) == 0; });
  if (scenes.empty()) throw UnknownCase("no case here: name a file, or run where a folder `cases` is");
  return scenes;
}

std::vector<PlannedJob> plan(const Scenes& scenes, const Catalogue& catalogue, const Store& store,
                             const RunOptions& options) {
  std::vector<PlannedJob> all;
  for (const auto& scene : scenes)
    for (const Job& job : part(jobs(*scene, catalogue), options.shard)) {
      const bool done = !options.again && stored(job, store).is_complete(options.timed);
      all.push_back({scene->name, scene->profile, job, done});
    }
  return all;
}

std::string asked(const Check& check) {
  if (!check.table.empty()) return subject_of(check);
  return runs_of(check) + " · " + subject_of(check) + (check.truth.empty() ? "" : " against " + check.truth);
}
std::string found(const CheckResult& result) {
  if (!result.measured || !result.check.status.empty()) return one_line(result.status, 1000);
  const std::string bar = result.error_bar > 0 ? fmt::format(" +- {:.1e}", result.error_bar) : "";
  return fmt::format("{:.4g}{}", result.value, bar);
}
std::string bound_in_words(const Check& check) {
  if (!check.status.empty()) return check.status;
  return check.at_most ? fmt::format("at most {}", *check.at_most) : fmt::format("at least {}", check.at_least.value());
}

// Prints every check of the scenes with what was measured; returns whether all hold. Where --set chose what ran, a
// check of what did not run is no failure: how many are not asked is said.
bool print_checks(const std::vector<Scene>& scenes, const StoredResults& stored, bool all_ran, const Console& console) {
  bool all = true;
  int n_not_asked = 0;
  const std::vector<CheckResult> results = check_results(scenes, stored.records, stored.findings);
  for (const CheckResult& result : results) {
    const Check& check = result.check;
    if (!all_ran && result.status == "no record") {
      ++n_not_asked;
      continue;
    }
    const bool open = result.measured && !result.decidable;  // no pass: what is not known does not hold
    fmt::print(console.out, "{:<5} {} · {} = {} (must be {}){}\n",
               result.holds ? "holds"
               : open       ? "OPEN"
                            : "FAILS",
               result.case_name, asked(check), found(result), bound_in_words(check),
               open ? ": within the error bar, not decidable" : "");
    all = all && result.holds;
  }
  if (n_not_asked > 0)
    fmt::print(console.err,
               "{} of {} check{} not asked: no run answers, as --set chose what runs; `run` without it asks all\n",
               n_not_asked, results.size(), results.size() == 1 ? "" : "s");
  return all;
}

void print_warnings(const std::vector<Scene>& scenes, const StoredResults& stored, const Console& console) {
  for (const Scene& scene : scenes)
    for (const std::string& warning : warnings(stored.records, scene))
      fmt::print(console.err, "warning: {} · {}\n", scene.name, warning);
}

struct Outcome {
  int n_failed = 0;
  bool interrupted = false;
  std::vector<Scene> finished;
};

Progress progress_on(const Console& console) {
  if (console.quiet) return [](const std::string&) {};
  return [&err = console.err](const std::string& line) { fmt::print(err, "{}\n", line), err.flush(); };
}

Outcome run_all(const Scenes& scenes, const Catalogue& catalogue, const Store& store, const RunOptions& options,
                const Console& console) {
  const Progress progress = progress_on(console);
  Outcome outcome;
  for (const auto& scene : scenes) try {
      const CaseOutcome one = run_case(scene, catalogue, store, options, progress);
      const bool may_be_old = one.n_failed > 0 && one.n_stored > 0;
      if (!console.quiet || one.n_failed > 0)
        fmt::print(console.err, "{} · {} runs done, {} found in {}, {} failed{}{}\n", scene->name, one.n_run,
                   one.n_stored, store.directory().string(), one.n_failed,
                   may_be_old
                       ? "; a failure that is stored stays until --again, one for want of memory until the next run"
                       : "",
                   scene->checks.empty() ? "; it states no check" : "");
      outcome.n_failed += one.n_failed;
      outcome.finished.push_back(*scene);
      if ((outcome.interrupted = one.interrupted)) break;
    } catch (const StoreError&) {
      throw;  // concerns every case
    } catch (const std::exception& error) {
      fmt::print(console.err, "{} · failed: {}\n", scene->name, one_line(failure_text(error, memory(*scene)), 1000));
      ++outcome.n_failed;
    }
  return outcome;
}

// As many as the memory holds, were each at the dearest job.
int n_processes(const Scene& scene, const std::vector<PlannedJob>& plan, std::optional<double> available, int most,
                const Progress& progress) {
  std::vector<double> needed;
  for (const PlannedJob& one : plan)
    if (!one.stored) needed.push_back(memory(scene, one.job, false) + memory_of_answers(scene));
  const int n = processes_that_fit(most, needed, available);
  if (n < most)
    progress(fmt::format("{} · {} of {} processes: no more fit the memory, {:.3g} GB", scene.name, n, most,
                         1e-9 * available.value_or(0)));
  return n;
}

// In a process of their own: threads that libraries start there would not survive a fork. What fails there is met
// again, and named, by who calls.
bool truths_are_there(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue, const Store& store,
                      const RunOptions& options, const Progress& progress) {
  const auto interrupted = [&] { return options.interrupted && options.interrupted(); };
  return in_processes(1, [&](int) {
           try {
             return truths(scene, catalogue, store, progress, interrupted) ? 0 : 130;
           } catch (const std::exception&) {
             return 3;
           }
         }) == 0;
}

// Marks and tables by several processes; what they fail at is met again, and counted, by who calls. Computes nothing
// itself before the last of them has ended.
void run_in_parallel(const Scenes& scenes, const Catalogue& catalogue, const Store& store, const RunOptions& options,
                     int n, const Console& console) {
  const Progress progress = progress_on(console);
  RunOptions shared = options;
  shared.timed = shared.alone = false;
  for (const auto& scene : scenes) {
    if (options.interrupted && options.interrupted()) return;
    auto left = plan({scene}, catalogue, store, shared);
    std::erase_if(left, [](const PlannedJob& one) { return takes_times(one.job); });
    if (std::ranges::all_of(left, &PlannedJob::stored)) continue;
    if (!truths_are_there(scene, catalogue, store, options, progress)) continue;
    shared.memory = available_memory();  // asked once: what one process takes is no reason to refuse another's
    const int n_now = n_processes(*scene, left, shared.memory, n, progress);
    in_processes(n_now, [&](int i) {
      shared.shard = options.shard.part(i, n_now);
      return run_all({scene}, catalogue, store, shared, console).n_failed > 0 ? 3 : 0;
    });
  }
}

}  // namespace

int run_command(const RunCommandOptions& options, const Catalogue& catalogue, const Console& given) {
  const Console console{given.out, given.err, options.quiet};
  const auto shard = parse_shard(options.shard);
  if (!shard) throw UsageError("--shard " + options.shard + ": must be i/n with 1 <= i <= n <= 1000000, as 2/8");
  const Scenes scenes = scenes_of(options, catalogue);
  const Store store(options.store);
  RunOptions how{options.again, !options.untimed, *shard, options.interrupted};
  if (options.plan) {
    const auto planned = plan(scenes, catalogue, store, how);
    options.json ? print_plan_json(planned, catalogue, console.out) : print_plan_table(planned, console.out);
    return 0;
  }
  set_blas_threads(options.threads);
  if (options.jobs > 1) {
    run_in_parallel(scenes, catalogue, store, how, options.jobs, console);
    how.again_timed = how.again;
    how.again = false;
  }
  const Outcome outcome = run_all(scenes, catalogue, store, how, console);
  const std::vector<RefusedLine> damaged = store.rebuild_results();
  const bool is_whole = !outcome.interrupted && shard->whole();  // checks are of the whole
  const StoredResults stored = is_whole ? current_records(store, outcome.finished) : StoredResults{};
  for (const RefusedLine& line : is_whole ? stored.refused : damaged)
    fmt::print(console.err, "left out: {}\n", to_string(line));
  if (outcome.interrupted) {
    fmt::print(console.err, "{}", words_of_interruption(options));
    return 130;
  }
  if (!is_whole) return outcome.n_failed > 0 ? 3 : 0;
  const bool checks_hold = print_checks(outcome.finished, stored, options.overrides.empty(), console);
  print_warnings(outcome.finished, stored, console);
  return outcome.n_failed > 0 ? 3 : checks_hold ? 0 : 1;
}

}  // namespace mb
