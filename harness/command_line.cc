// The command line (CLI11's door).
#include <CLI/CLI.hpp>

#include <fmt/ostream.h>

#include <csignal>
#include <iostream>

#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/main.h"
#include "harness/store/store.h"
#include "mechanics/algebra/threads.h"

namespace mb {

namespace {

volatile std::sig_atomic_t interrupt_requested = 0;  // what a signal handler may touch
void on_interrupt(int) {
  if (interrupt_requested) std::_Exit(130);  // a second Ctrl-C does not wait for the run at hand
  interrupt_requested = 1;
}

using Action = std::function<int(const Console&)>;

void add_list(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* command = app.add_subcommand("list", "cases and what each is about");
  command->add_option("pattern", options->pattern, "part of a name");
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return list_command(*options, catalogue, c); }; });
}

void add_profile(CLI::App& command, std::string& profile) {
  command.add_option("--profile", profile, "quick, standard or full")
      ->check(CLI::IsMember({"quick", "standard", "full"}))
      ->capture_default_str();
}

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
  CLI::App* command = app.add_subcommand("modes", "natural frequencies of a body, with residuals");
  command->add_option("case", options->case_name, "case name or file")->required();
  command->add_option("--body", options->body, "body of the case (default: the first)");
  command->add_option("--count", options->count, "modes, rigid ones included")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  command->add_flag("--json", options->json, "one JSON object");
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return modes_command(*options, catalogue, c); }; });
}

void add_run(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command = app.add_subcommand("run", "run cases, keep their results, check them");
  command->add_option("case", options->cases, "case names or files (default: all)");
  add_profile(*command, options->profile);
  command->add_option("--store", options->store, "where results are kept")->capture_default_str();
  command->add_flag("--plan", options->plan, "list the runs and whether they are stored");
  command->add_flag("--again", options->again, "run also what the store holds");
  options->interrupted = [] { return interrupt_requested != 0; };
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return run_command(*options, catalogue, c); }; });
}

void add_report(CLI::App& app, const Catalogue& catalogue, Action& action) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "write the report of what is stored");
  command->add_option("case", options->cases, "case names or files (default: those of the store, by name)");
  command->add_option("-o,--output", options->directory, "folder of the report")->capture_default_str();
  command->add_option("--store", options->store, "where results are kept")->capture_default_str();
  command->callback(
      [&, options] { action = [&, options](const Console& c) { return report_command(*options, catalogue, c); }; });
}

// Runs the action; names what went wrong and returns the exit code that says so.
int guarded(const Action& action, const Console& console) try {
  return action(console);
} catch (const CaseErrors& errors) {
  print(errors, console.err);
  return 2;
} catch (const UsageError& error) {
  fmt::print(console.err, "modalbench: {}\n", error.what());
  return 2;
} catch (const std::exception& error) {
  fmt::print(console.err, "modalbench: {}\n", error.what());
  return 3;
}

}  // namespace

int harness_main(int argc, char** argv, const Catalogue& catalogue) {
  CLI::App app{"Modalbench: what accuracy costs, for modal methods in elastodynamics", "modalbench"};
  app.require_subcommand(1);
  app.fallthrough();
  Action action;
  add_list(app, catalogue, action);
  add_check(app, catalogue, action);
  add_modes(app, catalogue, action);
  add_run(app, catalogue, action);
  add_report(app, catalogue, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::signal(SIGINT, on_interrupt);
  set_blas_threads(1);  // timed parts run on one thread on both sides
  return guarded(action, {std::cout, std::cerr});
}

}  // namespace mb
