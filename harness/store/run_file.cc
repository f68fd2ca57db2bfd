#include "harness/store/run_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "cases/json/finding_json.h"
#include "cases/json/json.h"
#include "harness/store/seal.h"

namespace mb {

RecordLines records_in(std::string_view bytes, const std::filesystem::path& file) {
  RecordLines lines;
  try {
    lines = read_records(unsealed(bytes), file);
  } catch (const std::runtime_error& fault) {
    return {{}, {{file, 0, fault.what()}}};
  }
  const bool is_empty = lines.records.empty() && lines.refused.empty();
  if (is_empty && file.parent_path().filename() == "records") lines.refused.push_back({file, 0, "holds no record"});
  const auto n_strangers = std::erase_if(lines.records, [&](const Record& r) { return r.run != file.stem(); });
  if (n_strangers > 0) {
    const std::string held = n_strangers == 1 ? "a record" : fmt::format("{} records", n_strangers);
    lines.refused.insert(lines.refused.begin(), {file, 0, fmt::format("holds {} of another run", held)});
  }
  return lines;
}

std::vector<Finding> findings_in(std::string_view bytes, const std::filesystem::path& file) {
  const Json list = parse_json(unsealed(bytes));
  if (!list.is_array()) throw std::runtime_error("holds no list of findings");
  std::vector<Finding> findings;
  for (const Json& entry : list) {
    findings.push_back(finding_from_json(entry));
    if (findings.back().run != file.stem()) throw std::runtime_error("holds a finding of another analysis");
  }
  return findings;
}

}  // namespace mb
