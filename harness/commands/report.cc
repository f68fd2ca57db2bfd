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

struct Known {
  std::vector<Scene> scenes;
  bool all_valid = true;
};

// Cases of the store, each in the profile that was run. A wrong case file is named and its case left out.
Known scenes_in(const Store& store, const ReportOptions& options, const Catalogue& catalogue, std::ostream& err) {
  const auto given = files_given(options, catalogue);
  std::set<std::pair<std::string, std::string>> names;
  for (const Record& record : store.read_all_records().records) names.insert({record.case_name, record.profile});
  Known known;
  for (const auto& [name, profile] : names) try {
      if (!given.empty() && !given.contains(name)) continue;
      const auto file = given.empty() ? find_case(name) : given.at(name);
      known.scenes.push_back(read_toml(file, catalogue.vocabulary(), profile));
    } catch (const UnknownCase&) {
      fmt::print(err, "the store holds results of '{}': left out; name its case file to have them reported\n", name);
    } catch (const CaseErrors& errors) {
      print(errors, err);
      fmt::print(err, "results of '{}' in profile {} are left out: its case file is wrong\n", name, profile);
      known.all_valid = false;
    }
  return known;
}

void print_left_out(const StoredResults& stored, std::ostream& err) {
  if (stored.n_other > 0) fmt::print(err, "{} records of other settings or builds left out\n", stored.n_other);
  if (stored.n_other_tables > 0)
    fmt::print(err,
               "{} tables of analyses left out: of other settings, as `run --set` has them, or of other builds; `run` "
               "without --set makes those of the case as it is\n",
               stored.n_other_tables);
  for (const RefusedLine& line : stored.refused)
    fmt::print(err, "{}:{}: left out: {}\n", line.file.string(), line.line, line.reason);
}

}  // namespace

int report_command(const ReportOptions& options, const Catalogue& catalogue, const Console& console) {
  if (!std::filesystem::is_directory(options.store)) throw UsageError("no store at '" + options.store + "'");
  const Store store(options.store);
  Known known = scenes_in(store, options, catalogue, console.err);
  ReportInput input{{}, {}, std::move(known.scenes), {}, meanings()};
  StoredResults stored = current_records(store, input.scenes);
  print_left_out(stored, console.err);
  input.records = std::move(stored.records);
  input.findings = std::move(stored.findings);
  input.environment = input.records.empty() ? provenance("none") : input.records.front().provenance;
  for (const auto& file : write_report(input, options.directory)) fmt::print(console.out, "{}\n", file.string());
  if (!page_available())
    fmt::print(console.err,
               "report.html is not written: the page was not built (it needs npm when Modalbench is built)\n");
  return known.all_valid ? 0 : 2;
}

}  // namespace mb
