// Puts a report into its folder: written aside as a whole, then renamed over the report before, so that a full disk or
// an interruption leaves that one as it was; signals that end a program wait for the end of it. Files of it that the
// new one no longer has go; nobody else's are touched.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace mb {

struct ReportFile {
  std::filesystem::path path;  // relative to the report's folder: its own name, or below data, tables or figures
  std::string text;
};

// Names what cannot be written, and why.
class PublishError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr const char* list_of_files = "data/files.txt";  // one path a line: what the next report may remove

// Returns the paths written, the list of files among them. Throws PublishError.
std::vector<std::filesystem::path> publish(std::vector<ReportFile> files, const std::filesystem::path& directory);

}  // namespace mb
