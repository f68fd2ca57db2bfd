#include <fmt/ostream.h>

#include <set>

#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/commands/stored_results.h"
#include "harness/metrics/metric.h"
#include "harness/provenance.h"
#include "reports/content.h"

namespace mb {

namespace {

// Cases of the store, each in the profile that was run.
std::vector<Scene> scenes_in(const Store& store, const Catalogue& catalogue, std::ostream& err) {
  std::set<std::pair<std::string, std::string>> names;
  for (const Record& record : store.read_all_records().records) names.insert({record.case_name, record.profile});
  std::vector<Scene> scenes;
  for (const auto& [name, profile] : names) try {
      scenes.push_back(read_toml(find_case(name), catalogue.vocabulary(), profile));
    } catch (const UnknownCase&) {
      fmt::print(err, "the store holds results of '{}', whose case file is not here: left out\n", name);
    }
  return scenes;
}

std::map<std::string, std::string> definitions() {
  std::map<std::string, std::string> docs;
  for (const Metric& metric : metric_catalogue()) docs[metric.name] = metric.doc;
  docs["online-time"] =
      "Load projection, stepping and reconstruction of displacements at the frame times, one thread, median of at "
      "least 5 runs and 0.2 s after a warm-up; the bar is half the distance of the quartiles. A time without a bar is "
      "that of a single run.";
  docs["offline-time"] =
      "What is done once per body and mesh before the first step: factorisations, eigensolve with its gate, "
      "projection. Assembly, which all share, is left out. One run.";
  docs["load-error"] =
      "Largest error, relative to the peak, in representing the load by lines and cosines: 0 for all histories but "
      "chirps "
      "and expressions, which are resampled.";
  return docs;
}

}  // namespace

int report_command(const ReportOptions& options, const Catalogue& catalogue, const Console& console) {
  const Store store(options.store);
  ReportInput input{{}, scenes_in(store, catalogue, console.err), {}, definitions()};
  StoredResults stored = current_records(store, input.scenes);
  if (stored.n_other > 0) fmt::print(console.err, "{} records of other settings or builds left out\n", stored.n_other);
  for (const RefusedLine& line : stored.refused)
    fmt::print(console.err, "{}:{}: left out: {}\n", line.file.string(), line.line, line.reason);
  input.records = std::move(stored.records);
  input.environment = input.records.empty() ? provenance("none") : input.records.front().provenance;
  for (const auto& file : write_report(input, options.directory)) fmt::print(console.out, "{}\n", file.string());
  if (!page_available())
    fmt::print(console.err,
               "report.html is not written: the page was not built (it needs npm when Modalbench is built)\n");
  return 0;
}

}  // namespace mb
