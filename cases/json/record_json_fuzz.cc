// Records and findings: whatever the line, it is refused in a sentence of our own, or what it says is written and read
// back the same.
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "cases/json/finding_json.h"
#include "cases/json/record_json.h"

namespace {

using namespace mb;

void require_sentence(const std::runtime_error& refusal) {
  const std::string text = refusal.what();
  if (text.empty() || !std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; }))
    throw std::logic_error("refused with text of the input");
}

// What `read` makes of the text, or nothing where it refuses.
template <class Read>
void require_same_again(const std::string& text, Read&& read) {
  std::string line;
  try {
    line = to_line(to_json(read(parse_json(text))));
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
