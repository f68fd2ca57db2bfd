// Files of a report. A file that cannot be written is an exception that names it, never a shorter report.
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "cases/json/record_json.h"
#include "reports/figures.h"
#include "reports/markdown_report.h"
#include "reports/page.h"
#include "reports/render.h"

namespace mb {
namespace {

namespace fs = std::filesystem;

struct File {
  fs::path path;
  std::string text;
};  // path relative to the report's directory

std::vector<Sheet> all_tables(const Analysis& analysis) {
  return {checks_table(analysis),   reduced_table(analysis), rivals_table(analysis),
          speed_up_table(analysis), probes_table(analysis),  failures_table(analysis)};
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

std::vector<File> compose(const Analysis& analysis) {
  std::vector<File> files = {{"report.md", markdown_report(analysis)},
                             {"data/results.jsonl", record_lines(analysis.input.records)},
                             {"data/records.csv", csv(records_table(analysis))}};
  for (const Sheet& table : all_tables(analysis)) {
    files.push_back({"data/" + table.name + ".csv", csv(table)});
    files.push_back({"tables/" + table.name + ".tex", latex_parts(table)});
  }
  for (const Figure& figure : figures(analysis)) {
    files.push_back({"figures/" + figure.name + ".vl.json", to_line(figure.specification) + "\n"});
  }
  if (page_available()) files.push_back({"report.html", page(analysis, page_template())});
  return files;
}

void write(const fs::path& path, const std::string& text) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) throw std::runtime_error("cannot make " + path.parent_path().string() + ": " + error.message());
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  if (!stream) {
    const std::string reason = errno ? std::generic_category().message(errno) : std::string("write failed");
    throw std::runtime_error("cannot write " + path.string() + ": " + reason);
  }
}

}  // namespace

bool page_available() { return !page_template().empty(); }

std::vector<fs::path> write_report(const ReportInput& input, const fs::path& directory) {
  std::vector<fs::path> written;
  for (const File& file : compose(analyse(input))) {
    written.push_back(directory / file.path);
    write(written.back(), file.text);
  }
  return written;
}

}  // namespace mb
