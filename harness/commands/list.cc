#include <fmt/ostream.h>

#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/study/plan.h"

namespace mb {

void print(const CaseErrors& errors, std::ostream& err) {
  for (const Diagnostic& diagnostic : errors.diagnostics()) err << to_string(diagnostic);
}

int list_command(const ListOptions& options, const Catalogue& catalogue, const Console& console) {
  int code = 0, n_listed = 0;
  for (const auto& file : all_cases()) {
    if (file.stem().string().find(options.pattern) == std::string::npos) continue;
    try {
      const Scene scene = read_toml(file, catalogue.vocabulary());
      fmt::print(console.out, "{:<28} {:>4} runs  {}\n", scene.name, contenders(scene).size(), scene.title);
      ++n_listed;
    } catch (const CaseErrors& errors) {
      print(errors, console.err);
      code = 2;
    }
  }
  if (n_listed == 0 && code == 0) {
    fmt::print(console.err, "no case{} here\n", options.pattern.empty() ? "" : " named like '" + options.pattern + "'");
    code = 2;
  }
  return code;
}

int check_command(const CheckOptions& options, const Catalogue& catalogue, const Console& console) {
  int n_errors = 0;
  for (const std::string& name : options.files) try {
      const Scene scene = read_toml(find_case(name), catalogue.vocabulary(), options.profile);
      fmt::print(console.out, "{}: valid (bodies: {}, contenders: {}, checks: {})\n", scene.name, scene.bodies.size(),
                 contenders(scene).size(), scene.checks.size());
    } catch (const CaseErrors& errors) {
      print(errors, console.err);
      n_errors += static_cast<int>(errors.diagnostics().size());
    }
  if (n_errors > 0) fmt::print(console.err, "{} error{}\n", n_errors, n_errors == 1 ? "" : "s");
  return n_errors == 0 ? 0 : 2;
}

}  // namespace mb
