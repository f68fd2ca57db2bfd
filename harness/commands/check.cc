#include <fmt/ostream.h>

#include "cases/scene/printable.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/study/plan.h"

namespace mb {

void print(const CaseErrors& errors, std::ostream& err) {
  for (const Diagnostic& diagnostic : errors.diagnostics()) err << to_string(diagnostic);
}

int check_command(const CheckOptions& options, const Catalogue& catalogue, const Console& console) {
  int n_errors = 0;
  NamedFiles named;
  for (const std::string& name : options.files) try {
      const auto file = find_case(name);
      const Scene scene = read_toml(file, catalogue.vocabulary(), options.profile);
      named.emplace_back(scene.name, file);
      fmt::print(console.out, "{}: valid (bodies: {}, contenders: {}, checks: {})\n", scene.name, scene.bodies.size(),
                 contenders(scene, catalogue).size(), scene.checks.size());
    } catch (const CaseErrors& errors) {
      print(errors, console.err);
      n_errors += static_cast<int>(errors.diagnostics().size());
    } catch (const UnknownCase& unknown) {
      fmt::print(console.err, "{}\n", one_line(unknown.what(), 4096));
      ++n_errors;
    }
  try {
    require_names_of_their_own(named);
  } catch (const UsageError& shared) {
    fmt::print(console.err, "{}\n", shared.what());
    ++n_errors;
  }
  if (n_errors > 0) fmt::print(console.err, "{} error{}\n", n_errors, n_errors == 1 ? "" : "s");
  return n_errors == 0 ? 0 : 2;
}

}  // namespace mb
