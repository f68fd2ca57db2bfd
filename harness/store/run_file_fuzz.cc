// Files of runs: whatever the bytes, with a seal of their own or under a right one, they are refused in sentences of
// our own, or what they say is written and read back the same. A forger knows the seal.
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "cases/json/finding_json.h"
#include "cases/json/json.h"
#include "harness/store/run_file.h"
#include "harness/store/seal.h"

namespace {

using namespace mb;

const std::string run = "0123456789abcdef0123456789abcdef";

void require(bool holds, const char* property) {
  if (!holds) throw std::logic_error(property);
}

void require_sentence(const std::string& text) {
  require(!text.empty() && std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; }),
          "refused with text of the input");
}

std::string lines_of(const std::vector<Record>& records) {
  std::string lines;
  for (const Record& record : records) lines += to_line(to_json(record)) + "\n";
  return lines;
}

void try_records(const std::string& bytes) {
  const std::filesystem::path file = "records/" + run + ".jsonl";
  const RecordLines read = records_in(bytes, file);
  const auto n_lines = std::ranges::count(bytes, '\n') + 1;
  for (const RefusedLine& refused : read.refused) {
    require_sentence(refused.reason);
    require(refused.line >= 0 && refused.line <= n_lines && refused.file == file, "refused where nothing is");
  }
  for (const Record& record : read.records) require(record.run == run, "a record of another run");
  if (read.records.empty()) return require(!read.refused.empty(), "nothing read, and nothing refused");
  const RecordLines again = records_in(sealed(lines_of(read.records)), file);
  require(again.refused.empty() && lines_of(again.records) == lines_of(read.records), "written and read, others");
}

void try_findings(const std::string& bytes) {
  const std::filesystem::path file = "findings/" + run + ".json";
  const auto list_of = [&](const std::string& from) {
    Json list = Json::array();
    for (const Finding& finding : findings_in(from, file)) list.push_back(to_json(finding));
    return to_line(list) + "\n";
  };
  std::string list;
  try {
    list = list_of(bytes);
  } catch (const std::runtime_error& refusal) {
    return require_sentence(refusal.what());
  }
  require(list_of(sealed(list)) == list, "written and read, other findings");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const std::string& bytes : {text, sealed(text)}) {
    try_records(bytes);
    try_findings(bytes);
  }
  require(unsealed(sealed(text)) == text, "sealed and unsealed, another text");
  return 0;
}
