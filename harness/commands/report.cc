#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <optional>
#include <set>

#include "cases/scene/diagnostics.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/commands/open_page.h"
#include "harness/metrics/definitions.h"
#include "harness/provenance.h"
#include "harness/store/file.h"
#include "harness/study/current_records.h"
#include "reports/content.h"
#include "reports/publish.h"

namespace mb {

namespace {

// The scenes of the files given, by their names.
std::map<std::string, std::filesystem::path> files_given(const ReportOptions& options, const Catalogue& catalogue) {
  NamedFiles files;
  for (const auto& file : find_cases(options.cases))
    files.emplace_back(read_toml(file, catalogue.vocabulary()).name, file);
  require_names_of_their_own(files);
  return {files.begin(), files.end()};
}

struct Known {
  std::vector<Scene> scenes;
  bool all_valid = true;
  std::vector<std::string> stored = {}, not_found = {};  // names of cases: all of the store; those without a case file
};

void add(std::vector<std::string>& names, const std::string& name) {
  if (names.empty() || names.back() != name) names.push_back(name);
}

// Cases of the store, each in the profile that was run. A wrong case file is named and its case left out.
Known scenes_in(const Store& store, const ReportOptions& options, const Catalogue& catalogue, std::ostream& err) {
  const auto given = files_given(options, catalogue);
  std::set<std::pair<std::string, std::string>> names;
  for (const Record& record : store.read_all_records().records) names.insert({record.case_name, record.profile});
  Known known;
  for (const auto& [name, profile] : names) try {
      add(known.stored, name);
      if (!given.empty() && !given.contains(name)) continue;
      const auto file = given.empty() ? find_case(name) : given.at(name);
      known.scenes.push_back(read_toml(file, catalogue.vocabulary(), profile));
    } catch (const UnknownCase&) {
      add(known.not_found, name);
      fmt::print(err, "the store holds results of '{}': left out; name its case file to have them reported\n", name);
    } catch (const CaseErrors& errors) {
      print(errors, err);
      fmt::print(err, "results of '{}' in profile {} are left out: its case file is wrong\n", name, profile);
      known.all_valid = false;
    }
  return known;
}

void print_left_out(const StoredResults& stored, bool quiet, std::ostream& err) {
  for (const RefusedLine& line : stored.refused)  // is wrong: said in any case
    fmt::print(err, "left out: {}\n", to_string(line));
  if (quiet) return;
  if (stored.n_other > 0) fmt::print(err, "{} records of other settings or builds left out\n", stored.n_other);
  if (stored.n_other_tables > 0)
    fmt::print(err,
               "{} tables of analyses left out: of other settings, as `run --set` has them, or of other builds; `run` "
               "without --set makes those of the case as it is\n",
               stored.n_other_tables);
}

std::vector<std::string> quoted(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back("'" + printable(name, 64) + "'");
  return all;
}

// Names of a store are untrusted, and readers paste commands into a shell.
std::string likely_file(const std::string& name) {
  const bool plain = name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
  return plain ? name + ".toml" : "FILE.toml";
}

// Where results are stored but none of them can be reported: why, and what helps. A report would say that there are
// none.
std::string nothing_to_report(const Known& known, const ReportOptions& options) {
  if (known.stored.empty())
    return "nothing to report: '" + options.store + "' holds no records; modalbench run makes them";
  if (!known.not_found.empty())
    return fmt::format("nothing to report: no case file is found by the name {}; name the file: modalbench report {}{}",
                       fmt::join(quoted(known.not_found), ", "), likely_file(known.not_found.front()),
                       options.store == "results" ? "" : " --store " + options.store);
  if (known.scenes.empty() && known.all_valid)
    return fmt::format("nothing to report: the store holds results of {} alone", fmt::join(quoted(known.stored), ", "));
  if (known.scenes.empty()) return "nothing to report: every case file that the store has results of is wrong";
  return "nothing to report: what is stored belongs to case files or builds that have changed since; modalbench run "
         "makes it anew";
}

// Of two reports at once into one folder, as of two stores, either is there as a whole in the end.
std::vector<std::filesystem::path> publish_alone(std::vector<ReportFile> files,
                                                 const std::filesystem::path& directory) {
  std::optional<FolderLock> lock;
  try {
    lock.emplace(directory);
  } catch (const StoreError&) {  // what keeps it from being written is told where it is
  }
  return publish(std::move(files), directory);
}

}  // namespace

int report_command(const ReportOptions& options, const Catalogue& catalogue, const Console& console) {
  if (!std::filesystem::is_directory(options.store)) throw UsageError("no store at '" + options.store + "'");
  const Store store(options.store);
  const Known known = scenes_in(store, options, catalogue, console.err);
  ReportInput input{{}, {}, known.scenes, {}, meanings()};
  StoredResults stored = current_records(store, input.scenes);
  print_left_out(stored, options.quiet, console.err);
  if (stored.records.empty() && stored.findings.empty()) throw UsageError(nothing_to_report(known, options));
  input.records = std::move(stored.records);
  input.findings = std::move(stored.findings);
  for (const RefusedLine& line : stored.refused) input.damaged.push_back(to_string(line));
  input.environment = input.records.empty() ? provenance("none") : input.records.front().provenance;
  const auto files = publish_alone(report_files(input), options.directory);
  for (const auto& file : files) fmt::print(console.out, "{}\n", file.string());
  if (!page_available() && !options.quiet)
    fmt::print(console.err,
               "report.html is not written: the page was not built (it needs npm when Modalbench is built)\n");
  if (options.open) open_page(files, console.err);
  return known.all_valid ? 0 : 2;
}

}  // namespace mb
