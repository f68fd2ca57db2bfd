// Problems of a case file, collected while it is read so that all of them are reported at once.
//
// Case files are untrusted: whatever is echoed from one is made printable and clipped first.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cases/scene/read_toml.h"

namespace mb {

struct Position {
  int line = 0, column = 0, length = 1;  // 1-based, columns count code points; line 0: the file as a whole
};

// Control, bidirectional and invisible characters become '?', tabs blanks; clipped to so many characters.
std::string printable(std::string_view text, std::size_t most = 64);

class Findings {
 public:
  Findings(std::string file, std::string_view text);  // the text must outlive this object
  void error(const Position& where, std::string message, std::string help = "");
  bool empty() const { return found_.empty(); }
  const std::string& file() const { return file_; }
  const std::vector<Diagnostic>& found() const { return found_; }

 private:
  std::string excerpt(int line) const;

  std::string file_;
  std::string_view text_;
  std::vector<std::size_t> line_starts_;
  std::vector<Diagnostic> found_;
};

}  // namespace mb
