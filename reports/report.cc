// What files a report has.
#include "cases/json/record_json.h"
#include "reports/claims.h"
#include "reports/environment.h"
#include "reports/figures.h"
#include "reports/findings.h"
#include "reports/hard_cases.h"
#include "reports/markdown_report.h"
#include "reports/matrix.h"
#include "reports/orders.h"
#include "reports/page.h"
#include "reports/polynomial_modes.h"
#include "reports/publish.h"
#include "reports/render.h"
#include "reports/speedup.h"
#include "reports/verdict.h"
#include "reports/verification.h"

namespace mb {
namespace {

std::vector<Sheet> all_tables(const Evaluation& evaluation) {
  const std::vector<SpeedUp> front = on_front(evaluation.speed_ups);
  return {hard_cases_table(evaluation),      hard_integrators_table(evaluation), verification_table(evaluation),
          headline_table(evaluation),        checks_table(evaluation),           matrix_table(evaluation),
          reduced_table(evaluation),         rivals_table(evaluation),           orders_table(curves(evaluation)),
          speed_up_table(evaluation, front), phases_table(evaluation, front),    polynomials_table(evaluation),
          claims_table(evaluation),          probes_table(evaluation),           failures_table(evaluation),
          environment_table(evaluation)};
}

// Keys of a table that are spelled out in the titles of its parts: case, profile, truth.
std::string latex_parts(const Sheet& table) {
  std::string text;
  for (const Sheet& part : split(table)) text += latex(part) + "\n";
  return text.empty() ? latex(table) : text;
}

std::string record_lines(const std::vector<Record>& records) {
  std::string text;
  for (const Record& record : records) text += to_line(to_json(record)) + "\n";
  return text;
}

void add_findings(std::vector<ReportFile>& files, const Evaluation& evaluation) {
  for (const Finding& finding : evaluation.input.findings) {
    const std::string stem = file_stem(evaluation, finding);
    const Sheet table = sheet_of(finding);
    files.push_back({"data/" + stem + ".csv", csv(table)});
    files.push_back({"tables/" + stem + ".tex", latex(shortened(table, longest_text_table, "data/" + stem + ".csv"))});
    for (const Figure& figure : finding_figures(finding)) {
      const std::string name = figure.name + "-" + file_part(finding.case_name) + "-" + file_part(finding.profile);
      files.push_back({"figures/" + name + ".vl.json", to_line(figure.specification) + "\n"});
    }
  }
}

std::vector<ReportFile> compose(const Evaluation& evaluation) {
  std::vector<ReportFile> files = {{"report.md", markdown_report(evaluation)},
                                   {"verification.md", verification_document(evaluation)},
                                   {"data/results.jsonl", record_lines(evaluation.input.records)},
                                   {"data/records.csv", csv(records_table(evaluation))},
                                   {"data/speed-up-all.csv", csv(speed_up_table(evaluation, evaluation.speed_ups))}};
  for (const Sheet& table : all_tables(evaluation)) {
    files.push_back({"data/" + table.name + ".csv", csv(table)});
    files.push_back({"tables/" + table.name + ".tex", latex_parts(table)});
  }
  for (const Figure& figure : figures(evaluation)) {
    files.push_back({"figures/" + figure.name + ".vl.json", to_line(figure.specification) + "\n"});
  }
  if (const auto bars = speed_up_figure(headline_pairs(evaluation))) {
    files.push_back({"figures/speed-up.vl.json", to_line(*bars) + "\n"});
  }
  add_findings(files, evaluation);
  if (page_available()) files.push_back({"report.html", page(evaluation, page_template())});
  return files;
}

}  // namespace

bool page_available() { return !page_template().empty(); }

std::vector<ReportFile> report_files(const ReportInput& input) { return compose(evaluate(input)); }

std::vector<std::filesystem::path> write_report(const ReportInput& input, const std::filesystem::path& directory) {
  return publish(report_files(input), directory);
}

}  // namespace mb
