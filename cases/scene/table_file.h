// A table history in a file of its own: lines `t, s` with t in [s], `#` comments, an optional header line of letters.
//
// The path is untrusted: it must lead to a regular file below the case's folder, with symbolic links resolved, and no
// message ever shows what the file holds.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/history/history.h"

namespace mb {

struct TableFile {
  Table table;
  std::vector<int> lines;  // of the file, from 1, of each entry
  std::string problem;     // empty: the table was read
};
TableFile read_table_file(const std::filesystem::path& folder, const std::string& path, std::size_t most_entries);
// The same of text at hand; shown: the name that messages show.
TableFile table_of_text(std::string_view text, const std::string& shown, std::size_t most_entries);

// What lies in a regular file of at most so many bytes, or why there is none.
struct FileText {
  std::string text, problem;
};
FileText read_text_file(const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace mb
