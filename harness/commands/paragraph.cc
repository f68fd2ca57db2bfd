#include "harness/commands/paragraph.h"

#include <algorithm>
#include <sstream>

#include "cases/scene/diagnostics.h"

namespace mb {

namespace {

int n_columns(std::string_view text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

std::string paragraph(std::string_view text, const std::string& first, const std::string& indent, int width) {
  std::istringstream words{std::string(text)};
  std::string all, line = first;
  bool empty = true;  // whether the line holds no word yet
  for (std::string word; words >> word; empty = false) {
    word = printable(word, word.size());
    if (!empty && n_columns(line) + 1 + n_columns(word) > width) {
      all += line + "\n";
      line = indent;
      empty = true;
    }
    line += (empty ? "" : " ") + word;
  }
  return all + line + "\n";
}

}  // namespace mb
