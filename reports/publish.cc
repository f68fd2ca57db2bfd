#include "reports/publish.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <set>
#include <system_error>

#include "cases/scene/table_file.h"
#include "reports/held_signals.h"
#include "reports/listed_files.h"

namespace mb {
namespace {

namespace fs = std::filesystem;

// Within the report's folder: a rename across file systems would be a copy, which a full disk can cut short.
constexpr const char* staging = ".unfinished-report.";  // and the process that writes it: several may at once

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw PublishError("cannot make " + path.string() + ": " + error.message());
}

void write(const fs::path& path, const std::string& text) {
  make_folder(path.parent_path());
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  if (!stream) {
    const std::string reason = errno ? std::generic_category().message(errno) : std::string("write failed");
    throw PublishError("cannot write " + path.string() + ": " + reason);
  }
}

void move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw PublishError("cannot write " + to.string() + ": " + error.message());
}

void require_no_folder(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw PublishError("cannot write " + path.string() + ": Is a directory");
}

// Files written aside; gone again, and their disk space with them, if the report is not finished.
class Aside {
 public:
  explicit Aside(fs::path path) : path_(std::move(path)) { remove(); }
  ~Aside() { remove(); }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;
  const fs::path& path() const { return path_; }

 private:
  void remove() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path path_;
};

// What processes left behind that are no more.
void remove_abandoned(const fs::path& directory) {
  std::error_code error;
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(staging)) continue;
    const pid_t writer = std::atoi(name.c_str() + std::string(staging).size());
    if (writer <= 0 || (kill(writer, 0) != 0 && errno == ESRCH)) left.push_back(entry.path());
  }
  for (const fs::path& path : left) fs::remove_all(path, error);
}

constexpr std::size_t longest_list = 1 << 20;  // [bytes]

std::set<fs::path> files_of_report_in(const fs::path& directory) {  // none where the list is no list
  const std::set<std::string> files = listed_files(read_text_file(directory / list_of_files, longest_list).text);
  return {files.begin(), files.end()};
}

// A figure goes with the drawing that web/svg.mjs puts beside it.
void remove_figure_or_file(const fs::path& path) {
  static const std::string figure = ".vl.json";
  std::error_code ignored;
  fs::remove(path, ignored);
  const std::string name = path.string();
  if (name.ends_with(figure)) fs::remove(name.substr(0, name.size() - figure.size()) + ".svg", ignored);
}

ReportFile list_of(const std::vector<ReportFile>& files) {
  std::string text;
  for (const ReportFile& file : files) text += file.path.generic_string() + "\n";
  return {list_of_files, text + list_of_files + "\n"};
}

}  // namespace

std::vector<fs::path> publish(std::vector<ReportFile> files, const fs::path& directory) {
  files.push_back(list_of(files));
  const HeldSignals held;  // Ctrl-C comes after the last file, and leaves neither half a report nor what was put aside
  make_folder(directory);
  remove_abandoned(directory);
  const Aside aside(directory / (staging + std::to_string(getpid())));
  for (const ReportFile& file : files) write(aside.path() / file.path, file.text);
  std::set<fs::path> stale = files_of_report_in(directory);
  for (const ReportFile& file : files) make_folder((directory / file.path).parent_path());
  std::set<fs::path> paths;  // of names alike in all that a file name keeps of them, the last one stands
  for (const ReportFile& file : files) paths.insert(file.path);
  for (const fs::path& path : paths) require_no_folder(directory / path);  // before the first is replaced
  std::vector<fs::path> written;
  for (const fs::path& path : paths) {
    written.push_back(directory / path);
    move(aside.path() / path, written.back());
    stale.erase(path);
  }
  for (const fs::path& path : stale) remove_figure_or_file(directory / path);
  return written;
}

}  // namespace mb
