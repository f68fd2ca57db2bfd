#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include "cases/json/json.h"
#include "cases/scene/diagnostics.h"
#include "cases/scene/printable.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/study/estimate.h"
#include "harness/study/plan.h"

namespace mb {

namespace {

struct Entry {
  Scene scene;
  size_t n_runs;   // of contenders and analyses
  double minutes;  // estimated, profile quick
};

std::string about(const Scene& scene) {
  return printable(scene.exercises.empty() ? scene.title : scene.exercises, 200);
}

// The profiles in which a bare `run` takes the case; named, it runs in any.
std::string profiles_of(const Scene& scene) {
  return scene.runs_in.size() == 3 ? "every profile" : fmt::format("{}", fmt::join(scene.runs_in, ", "));
}

void print_table(const std::vector<Entry>& entries, std::ostream& out) {
  fmt::print(out, "{:<28} {:<16} {:>5} {:>8}  {}\n", "case", "in", "runs", "minutes", "exercises");
  for (const Entry& entry : entries)
    fmt::print(out, "{:<28} {:<16} {:>5} {:>8.2g}  {}\n", entry.scene.name, profiles_of(entry.scene), entry.n_runs,
               entry.minutes, about(entry.scene));
}

// The names that a case file may use.
void print_names(const Vocabulary& names, std::ostream& out) {
  fmt::print(
      out,
      "\n`in`: the profiles in which `run` takes a case that is not named. Runs and minutes (estimated) are of the "
      "quick profile.\nNames for case files and --set:\n");
  fmt::print(out, "  methods      {}\n", fmt::join(names.methods, ", "));
  fmt::print(out, "  integrators  {}\n", fmt::join(names.integrators, ", "));
  fmt::print(out, "  analyses     {}\n", fmt::join(names.analyses, ", "));
  fmt::print(out, "  metrics      {}\n", fmt::join(names.metrics, ", "));
}

void print_json(const std::vector<Entry>& entries, std::ostream& out) {
  Json cases = Json::array();
  for (const Entry& entry : entries)
    cases.push_back({{"name", entry.scene.name},
                     {"title", entry.scene.title},
                     {"exercises", entry.scene.exercises},
                     {"hard", entry.scene.hard},
                     {"runs_in", entry.scene.runs_in},
                     {"n_runs", entry.n_runs},
                     {"estimated_minutes", entry.minutes}});
  fmt::print(out, "{}\n", to_line({{"schema", 1}, {"profile", "quick"}, {"cases", cases}}));
}

}  // namespace

int list_command(const ListOptions& options, const Catalogue& catalogue, const Console& console) {
  int code = 0;
  std::vector<Entry> entries;
  for (const auto& file : all_cases()) {
    if (file.stem().string().find(options.pattern) == std::string::npos) continue;
    try {
      const Scene scene = read_toml(file, catalogue.vocabulary());
      entries.push_back({scene, jobs(scene, catalogue).size(), estimate(scene, catalogue).total() / 60});
    } catch (const CaseErrors& errors) {
      print(errors, console.err);
      code = 2;
    }
  }
  if (entries.empty() && code == 0) {
    fmt::print(console.err, "no case{} here\n",
               options.pattern.empty() ? "" : " named like '" + printable(options.pattern) + "'");
    return 2;
  }
  if (options.json)
    print_json(entries, console.out);
  else if (!entries.empty())
    print_table(entries, console.out), print_names(catalogue.vocabulary(), console.out);
  return code;
}

}  // namespace mb
