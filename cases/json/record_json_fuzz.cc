// Records and findings: whatever the line, it is refused in a sentence of our own, or what it says is written and read
// back the same.
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "cases/json/finding_json.h"
#include "cases/json/json.h"
#include "cases/json/record_json.h"
#include "cases/scene/printable.h"

namespace {

using namespace mb;

void require_sentence(const std::runtime_error& refusal) {
  const std::string text = refusal.what();
  if (text.empty() || !std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; }))
    throw std::logic_error("refused with text of the input");
}

void require_prints(const std::string& text) {
  if (printable(text, text.size()) != text) throw std::logic_error("a text that does not print was let in");
}
void require_prints(const Record& record) {
  for (const std::string* text : {&record.status, &record.unit, &record.subject}) require_prints(*text);
  for (const auto& [key, text] : record.provenance) require_prints(key), require_prints(text);
}
void require_prints(const Finding& finding) {
  for (const std::string* text : {&finding.title, &finding.note, &finding.footing.reference}) require_prints(*text);
  for (const FindingColumn& column : finding.columns) require_prints(column.name), require_prints(column.unit);
  for (const auto& row : finding.rows)
    for (const FindingCell& cell : row)
      if (const auto* text = std::get_if<std::string>(&cell)) require_prints(*text);
}

// What `read` makes of the text, or nothing where it refuses.
template <class Read>
void require_same_again(const std::string& text, Read&& read) {
  std::string line;
  try {
    const auto what = read(parse_json(text));
    require_prints(what);
    line = to_line(to_json(what));
  } catch (const std::runtime_error& refusal) {
    return require_sentence(refusal);
  }
  if (to_line(to_json(read(parse_json(line)))) != line) throw std::logic_error("written and read, it is another");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  require_same_again(text, [](const Json& json) { return record_from_json(json); });
  require_same_again(text, [](const Json& json) { return finding_from_json(json); });
  return 0;
}
