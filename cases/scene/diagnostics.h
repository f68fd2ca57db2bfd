// Problems of a case file, collected while it is read so that all of them are reported at once.
//
// Case files are untrusted: whatever is echoed from one is made printable and clipped first.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cases/scene/printable.h"
#include "cases/scene/read_toml.h"

namespace mb {

struct Position {
  int line = 0, column = 0, length = 1;  // 1-based, columns count code points; line 0: the file as a whole
};

class Findings {
 public:
  Findings(std::string file, std::string_view text);  // the text must outlive this object
  // The same message at the same place is recorded once: three profiles may each find it.
  void error(const Position& where, std::string message, std::string help = "");
  // Every key that the reader asked for: "body.material.density" -> "a number in [1e-3, 1e5] kg/m^3".
  void ask(const std::string& path, const std::string& what) { asked_.emplace(path, what); }
  const std::map<std::string, std::string>& asked() const { return asked_; }
  bool empty() const { return found_.empty(); }
  const std::string& file() const { return file_; }
  const std::vector<Diagnostic>& found() const { return found_; }

 private:
  std::string excerpt(int line) const;

  std::string file_;
  std::string_view text_;
  std::vector<std::size_t> line_starts_;
  std::vector<Diagnostic> found_;
  std::map<std::string, std::string> asked_;
};

}  // namespace mb
