#include "harness/store/store.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "cases/json/finding_json.h"
#include "cases/json/json.h"
#include "harness/store/file.h"
#include "harness/store/hash.h"
#include "harness/store/run_file.h"
#include "harness/store/seal.h"

namespace mb {

namespace {

constexpr std::pair<const char*, const char*> shelves[] = {
    {"trajectories", ".h5"}, {"truth", ".h5"}, {"records", ".jsonl"}, {"timings", ".jsonl"}, {"findings", ".json"}};

std::string lines_of(const std::vector<Record>& records) {
  std::string lines;
  for (const Record& record : records) lines += to_line(to_json(record)) + "\n";
  return lines;
}

constexpr std::uintmax_t largest = 1 << 24;  // [bytes] of the records or findings of one run; some 10^5 are usual

// Never more than is read again.
void write_checked(const std::filesystem::path& file, const std::string& text,
                   const std::function<void()>& before_rename = {}) {
  if (text.size() > largest) throw StoreError(file, fmt::format("would be larger than {} bytes", largest));
  write_file(file, text, before_rename);
}

// The files of runs in the folder, sorted; temporary files of a run that was interrupted have other endings.
std::vector<std::filesystem::path> files_of_runs(const std::filesystem::path& folder, const char* ending) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(folder)) return files;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::filesystem::path& file = entry->path();
    if (file.extension() == ending && is_content_hash(file.stem().string())) files.push_back(file);
  }
  if (error) throw StoreError(folder, "cannot be listed: " + error.message());
  std::ranges::sort(files);
  return files;
}

RecordLines records_of(const std::filesystem::path& path) {
  try {
    return records_in(read_file(path, largest), path);
  } catch (const StoreError& fault) {
    return {{}, {{path, 0, fault.fault()}}};
  }
}

Store::Findings read_findings(const std::vector<std::filesystem::path>& files) {
  Store::Findings all;
  for (const std::filesystem::path& path : files) try {
      std::ranges::move(findings_in(read_file(path, largest), path), std::back_inserter(all.findings));
    } catch (const StoreError& error) {
      all.refused.push_back({path, 0, error.fault()});
    } catch (const std::exception& error) {
      all.refused.push_back({path, 0, error.what()});
    }
  return all;
}

bool holds(const std::filesystem::path& file, const std::string& text) {
  std::error_code error;
  if (std::filesystem::file_size(file, error) != text.size() || error) return false;
  return read_file(file, text.size()) == text;
}

}  // namespace

Store::Store(std::filesystem::path directory) : directory_(std::move(directory)) {}

std::filesystem::path Store::file(const char* shelf, const std::string& hash, const char* ending) const {
  if (!is_content_hash(hash)) throw std::invalid_argument("store: a run is named by 32 hex digits");
  return directory_ / shelf / (hash + ending);
}

void Store::require_writable() const {
  const std::filesystem::path probe = directory_ / fmt::format("probe.{}", ::getpid());
  write_file(probe, "");
  remove_file(probe);
  for (const auto& [shelf, ending] : shelves) {
    const std::filesystem::path folder = directory_ / shelf;
    std::error_code error;
    if (!std::filesystem::exists(std::filesystem::symlink_status(folder, error))) continue;
    if (!std::filesystem::is_directory(folder, error))
      throw StoreError(folder, "no folder, where one belongs; remove it");
    if (::access(folder.c_str(), W_OK | X_OK) != 0) throw StoreError(folder, std::strerror(errno));
  }
}

void Store::require_room(const std::string& hash) const {
  for (const auto& [shelf, ending] : shelves) {
    const std::filesystem::path path = file(shelf, hash, ending);
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw StoreError(path, "a folder is in the way; remove it");
  }
}

bool Store::has_trajectory(const std::string& hash) const {
  std::error_code error;
  return std::filesystem::exists(file("trajectories", hash, ".h5"), error);
}
Trajectory Store::read_trajectory(const std::string& hash) const {
  return mb::read_trajectory(file("trajectories", hash, ".h5"), hash);
}
void Store::write_trajectory(const std::string& hash, const Trajectory& trajectory) const {
  mb::write_trajectory(file("trajectories", hash, ".h5"), trajectory, hash);
}

bool Store::has_truth(const std::string& hash) const {
  std::error_code error;
  return std::filesystem::exists(file("truth", hash, ".h5"), error);
}
Trajectory Store::read_truth(const std::string& hash) const {
  return mb::read_trajectory(file("truth", hash, ".h5"), hash);
}
void Store::write_truth(const std::string& hash, const Trajectory& trajectory) const {
  mb::write_trajectory(file("truth", hash, ".h5"), trajectory, hash);
}

bool Store::has_records(const std::string& hash) const {
  std::error_code error;
  return std::filesystem::exists(file("records", hash, ".jsonl"), error);
}
void Store::write_records(const std::string& hash, const std::vector<Record>& records) const {
  if (!std::ranges::all_of(records, [&](const Record& record) { return record.run == hash; })) {
    throw std::invalid_argument("store: a record of another run");
  }
  // Other marks: the old times are not theirs, and never stand beside them, whenever this is ended.
  write_checked(file("records", hash, ".jsonl"), sealed(lines_of(records)),
                [&] { remove_file(file("timings", hash, ".jsonl")); });
}

bool Store::has_times(const std::string& hash) const {
  std::error_code error;
  return std::filesystem::exists(file("timings", hash, ".jsonl"), error);
}
void Store::write_times(const std::string& hash, const std::vector<Record>& times) const {
  if (!std::ranges::all_of(times, [&](const Record& record) { return record.run == hash; })) {
    throw std::invalid_argument("store: a time of another run");
  }
  write_checked(file("timings", hash, ".jsonl"), sealed(lines_of(times)));
}
RecordLines Store::read_records_of(const std::string& hash) const {
  return records_of(file("records", hash, ".jsonl"));
}
RecordLines Store::read_times_of(const std::string& hash) const { return records_of(file("timings", hash, ".jsonl")); }

bool Store::has_findings(const std::string& hash) const {
  std::error_code error;
  return std::filesystem::exists(file("findings", hash, ".json"), error);
}
void Store::write_findings(const std::string& hash, const std::vector<Finding>& findings) const {
  Json list = Json::array();
  for (const Finding& finding : findings) {
    if (finding.run != hash) throw std::invalid_argument("store: a finding of another analysis");
    list.push_back(to_json(finding));
  }
  write_checked(file("findings", hash, ".json"), sealed(to_line(list) + "\n"));
}

Store::Findings Store::read_findings_of(const std::string& hash) const {
  return read_findings({file("findings", hash, ".json")});
}
Store::Findings Store::read_all_findings() const {
  return read_findings(files_of_runs(directory_ / "findings", ".json"));
}

RecordLines Store::read_all_records() const {
  std::vector<std::filesystem::path> paths = files_of_runs(directory_ / "records", ".jsonl");
  std::ranges::copy(files_of_runs(directory_ / "timings", ".jsonl"), std::back_inserter(paths));
  std::ranges::stable_sort(paths, {}, [](const auto& path) { return path.stem(); });
  RecordLines all;
  for (const std::filesystem::path& path : paths) {
    RecordLines lines = records_of(path);
    std::ranges::move(lines.records, std::back_inserter(all.records));
    std::ranges::move(lines.refused, std::back_inserter(all.refused));
  }
  return all;
}

std::vector<RefusedLine> Store::rebuild_results() const {
  const FolderLock lock(directory_);  // of several at once the last to write is the last to have looked
  RecordLines all = read_all_records();
  const std::filesystem::path file = directory_ / "results.jsonl";
  const std::string lines = lines_of(all.records);
  if (!holds(file, lines)) write_file(file, lines);  // a store may be read from a read-only disk
  return std::move(all.refused);
}

}  // namespace mb
