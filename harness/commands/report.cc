#include <fmt/ostream.h>

#include <set>

#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/metrics/definitions.h"
#include "harness/provenance.h"
#include "harness/study/current_records.h"
#include "reports/content.h"

namespace mb {

namespace {

// The scenes of the files given, by their names.
std::map<std::string, std::filesystem::path> files_given(const ReportOptions& options, const Catalogue& catalogue) {
  std::map<std::string, std::filesystem::path> files;
  for (const std::string& name : options.cases) {
    const auto file = find_case(name);
    files[read_toml(file, catalogue.vocabulary()).name] = file;
  }
  return files;
}

// Cases of the store, each in the profile that was run.
std::vector<Scene> scenes_in(const Store& store, const ReportOptions& options, const Catalogue& catalogue,
                             std::ostream& err) {
  const auto given = files_given(options, catalogue);
  std::set<std::pair<std::string, std::string>> names;
  for (const Record& record : store.read_all_records().records) names.insert({record.case_name, record.profile});
  std::vector<Scene> scenes;
  for (const auto& [name, profile] : names) try {
      if (!given.empty() && !given.contains(name)) continue;
      const auto file = given.empty() ? find_case(name) : given.at(name);
      scenes.push_back(read_toml(file, catalogue.vocabulary(), profile));
    } catch (const UnknownCase&) {
      fmt::print(err, "the store holds results of '{}': left out; name its case file to have them reported\n", name);
    }
  return scenes;
}

}  // namespace

int report_command(const ReportOptions& options, const Catalogue& catalogue, const Console& console) {
  const Store store(options.store);
  ReportInput input{{}, {}, scenes_in(store, options, catalogue, console.err), {}, meanings()};
  StoredResults stored = current_records(store, input.scenes);
  if (stored.n_other > 0) fmt::print(console.err, "{} records of other settings or builds left out\n", stored.n_other);
  for (const RefusedLine& line : stored.refused)
    fmt::print(console.err, "{}:{}: left out: {}\n", line.file.string(), line.line, line.reason);
  input.records = std::move(stored.records);
  input.findings = std::move(stored.findings);
  input.environment = input.records.empty() ? provenance("none") : input.records.front().provenance;
  for (const auto& file : write_report(input, options.directory)) fmt::print(console.out, "{}\n", file.string());
  if (!page_available())
    fmt::print(console.err,
               "report.html is not written: the page was not built (it needs npm when Modalbench is built)\n");
  return 0;
}

}  // namespace mb
