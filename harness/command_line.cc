// The command line (CLI11's door).
#include <CLI/CLI.hpp>

#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <sstream>

#include "cases/scene/nearest.h"
#include "cases/scene/printable.h"
#include "harness/commands/bytes.h"
#include "harness/commands/command_again.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/instruction_counter.h"
#include "harness/interruptible.h"
#include "harness/main.h"
#include "harness/metis_signals.h"
#include "harness/store/store.h"
#include "harness/study/memory.h"
#include "harness/study/overrides.h"
#include "harness/study/processes.h"
#include "mechanics/algebra/threads.h"
#include "reports/publish.h"
#include "version.h"

namespace mb {

namespace {

int run_until_interrupted(const RunCommandOptions& options, const Catalogue& catalogue, const Console& console) {
  const Interruptible while_it_runs(words_of_interruption(options));
  return run_command(options, catalogue, console);
}

// The child that counts ends by the signal itself, and this one with what it has made.
int count_until_interrupted(const CountOptions& options, const Catalogue& catalogue, const Console& console) {
  if (is_counting()) return count_command(options, catalogue, console);
  const Interruptible while_it_counts("interrupted\n");
  try {
    return count_command(options, catalogue, console);
  } catch (const std::runtime_error&) {
    if (!interrupted()) throw;
    return 130;
  }
}

using Action = std::function<int(const Console&)>;

void add_list(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* command = app.add_subcommand("list", "cases and what each is about");
  command->add_option("pattern", options->pattern, "part of a name");
  command->add_flag("--json", options->json, "one JSON object");
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return list_command(*options, catalogue, c); }; });
}

void add_profile(CLI::App& command, std::string& profile) {
  command.add_option("--profile", profile, "quick, standard or full")
      ->check(CLI::IsMember({"quick", "standard", "full"}))
      ->capture_default_str();
}

// An unset variable of a shell is no folder: files would lie about in the current one.
// Nor is one whose name would move a terminal's cursor wherever it is told.
const CLI::Validator named(
    [](const std::string& folder) -> std::string {
      if (folder.empty()) return "names no folder";
      return unprintable(folder) ? "names a folder with characters that cannot be shown: " + printable(folder, 200)
                                 : "";
    },
    "FOLDER");

void add_check(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "read case files and report every problem");
  command->add_option("file", options->files, "case files or names")->required();
  add_profile(*command, options->profile);
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return check_command(*options, catalogue, c); }; });
}

void add_modes(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<ModesOptions>();
  CLI::App* command = app.add_subcommand("modes", "natural frequencies of a body, residuals, degrees, participation");
  command->add_option("case", options->case_name, "case name or file")->required();
  command->add_option("--body", options->body, "body of the case (default: the first)");
  command->add_option("--count", options->count, "modes, rigid ones included")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  command->add_flag("--json", options->json, "one JSON object");
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return modes_command(*options, catalogue, c); }; });
}

void add_count(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<CountOptions>();
  CLI::App* command = app.add_subcommand("count", "instructions that a case with contact takes, by valgrind");
  command->add_option("case", options->case_name, "case name or file")->required();
  add_profile(*command, options->profile);
  command->callback([&, options] {
    action = [&, options](const Console& c) { return count_until_interrupted(*options, catalogue, c); };
  });
}

void add_run(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command = app.add_subcommand("run", "run cases, keep their results, check them");
  command->add_option("case", options->cases, "case names or files (default: all)");
  add_profile(*command, options->profile);
  command->add_option("--store", options->store, "where results are kept")->capture_default_str()->check(named);
  command
      ->add_option("--set", options->overrides,
                   fmt::format("KEY=VALUE[,VALUE...] for {}; may be given again", fmt::join(set_keys(), ", ")))
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--jobs", options->jobs, "processes; times are taken afterwards, alone")
      ->check(CLI::Range(1, most_processes))
      ->capture_default_str();
  command->add_option("--threads", options->threads, "of the BLAS, in timed parts, too; records name them")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--shard", options->shard, "i/n: only that part of the jobs; merging is copying the store")
      ->capture_default_str();
  command->add_flag("--plan", options->plan, "list the jobs and whether they are stored");
  command->add_flag("--json", options->json, "the plan as one JSON object")->needs("--plan");
  command->add_flag("--untimed", options->untimed, "marks and tables only; run again without it to take the times");
  command->add_flag("-q,--quiet", options->quiet, "no progress on stderr: checks, and what fails");
  auto* const again = command->add_flag("--again", options->again, "run also what the store holds");
  command->add_flag("--resume")
      ->description("go on with what an interrupted run left: what happens anyway")
      ->excludes(again);
  options->interrupted = interrupted;
  command->callback([&, options] {
    action = [&, options](const Console& c) { return run_until_interrupted(*options, catalogue, c); };
  });
}

void add_report(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "write the report of what is stored");
  command->add_option("case", options->cases, "case names or files (default: those of the store, by name)");
  command->add_option("-o,--output", options->directory, "folder of the report")->capture_default_str()->check(named);
  command->add_option("--store", options->store, "where results are kept")->capture_default_str()->check(named);
  command->add_flag("--open", options->open, "show the page, by xdg-open");
  command->add_flag("-q,--quiet", options->quiet, "nothing on stderr but what is wrong: not what is left out");
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return report_command(*options, catalogue, c); }; });
}

void add_new(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<NewOptions>();
  CLI::App* command = app.add_subcommand("new", "write an annotated case: every key, unit, range, default");
  auto* const file = command->add_option("file", options->file, "a .toml file that is not there yet");
  auto* const schema = command->add_flag("--json-schema", options->json_schema, "print a schema for editors instead");
  file->excludes(schema);
  command->callback([&, options] {
    if (options->file.empty() && !options->json_schema) throw CLI::RequiredError("file");
    action = [&, options](const Console& c) { return new_command(*options, catalogue, c); };
  });
}

void add_explain(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = app.add_subcommand("explain", "definition, formula and source of a word of the suite");
  command->add_option("word", options->word, "a case, metric, key, method, integrator or analysis")->required();
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return explain_command(*options, catalogue, c); }; });
}

void add_doctor(CLI::App& app, Action& action) {
  auto options = std::make_shared<DoctorOptions>();
  CLI::App* command = app.add_subcommand("doctor", "cores, threads, BLAS in use, clock noise");
  command->add_option("--store", options->store, "whose disk is looked at")->capture_default_str()->check(named);
  command->add_flag("--json", options->json, "one JSON object");
  command->callback([&, options] { action = [options](const Console& c) { return doctor_command(*options, c); }; });
}

void add_clean(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<CleanOptions>();
  CLI::App* command = app.add_subcommand("clean", "what the store holds and what would go, sizes first");
  command->add_option("case", options->cases, "files of cases that are not found by name");
  command->add_option("--older", options->older, "an age like 30d: what is older goes as well");
  command->add_flag("--yes", options->yes, "delete it");
  command->add_option("--store", options->store, "where results are kept")->capture_default_str()->check(named);
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return clean_command(*options, catalogue, c); }; });
}

// Does what the words say; names what went wrong and returns the exit code that says so.
int guarded(const std::function<int()>& action, const std::string& command, const Console& console) {
  const auto say = [&](const std::string& what, int code) {
    fmt::print(console.err, "modalbench: {}\n", one_line(what, 4096));
    return code;
  };
  try {
    return action();
  } catch (const CaseErrors& errors) {
    print(errors, console.err);
    return 2;
  } catch (const UsageError& error) {
    return say(error.what(), 2);
  } catch (const StoreError& error) {  // a store that cannot be written or listed
    return say(error.what(), 2);
  } catch (const PublishError& error) {
    return say(error.what(), 2);
  } catch (const std::filesystem::filesystem_error& error) {
    return say(error.what(), 2);
  } catch (const std::bad_alloc&) {
    const auto left = available_memory();
    return say(command + ": out of memory" + (left ? fmt::format(", {} are left", bytes(*left)) : ""), 3);
  } catch (const std::exception& error) {
    return say(error.what(), 3);
  }
}

// CLI11 says of a word in the place of a command that there is none, and helps with any.
void expect_command(const CLI::App& app, const std::string& first) {
  if (first.empty() || first.starts_with('-')) return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::ranges::find(names, first) != names.end()) return;
  throw UsageError(fmt::format("no command '{}': {}", first, suggestion(first, names, "commands")));
}

// Help, or what is wrong with the words given, line by line without what would not print.
int told(CLI::App& app, const CLI::ParseError& error, const Console& console) {
  std::ostringstream out, err;
  const int code = app.exit(error, out, err) == 0 ? 0 : 2;
  for (const auto& [text, stream] : {std::pair(out.str(), &console.out), std::pair(err.str(), &console.err)}) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) fmt::print(*stream, "{}\n", printable(line, line.size()));
  }
  return code;
}

// The exit code, once what was printed has arrived: a full disk or a closed pipe must not pass for success.
int delivered(int code, const Console& console) {
  console.out.flush();
  if (console.out.good()) return code;
  fmt::print(console.err, "modalbench: what was to be printed could not be written\n");
  return 2;
}

int as_told(int argc, char** argv, const Catalogue& catalogue, const Console& console) {
  CLI::App app{"Modalbench: what accuracy costs, for modal methods in elastodynamics", "modalbench"};
  app.set_version_flag("--version", std::string("modalbench ") + version, "print the version of the program and exit");
  app.require_subcommand(1);
  app.fallthrough();
  Action action;
  add_list(app, catalogue, action);
  add_check(app, catalogue, action);
  add_modes(app, catalogue, action);
  add_count(app, catalogue, action);
  add_run(app, catalogue, action);
  add_report(app, catalogue, action);
  add_new(app, catalogue, action);
  add_explain(app, catalogue, action);
  add_doctor(app, action);
  add_clean(app, catalogue, action);
  expect_command(app, argc > 1 ? argv[1] : "");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return told(app, error, console);
  }
  use_one_thread();  // timed parts run on one thread on both sides
  return action(console);
}

}  // namespace

int harness_main(int argc, char** argv, const Catalogue& catalogue) {
  const Console console{std::cout, std::cerr};
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow further is an error like a full disk
  keep_signals_from_metis();
  if (!is_counting()) end_interrupted_on_signals();  // who counts ends by the signal itself: its parent tells
  const std::string command = argc > 1 ? argv[1] : "no command";
  return delivered(guarded([&] { return as_told(argc, argv, catalogue, console); }, command, console), console);
}

}  // namespace mb
