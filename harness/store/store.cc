#include "harness/store/store.h"

#include <algorithm>
#include <stdexcept>

#include "harness/store/hash.h"

namespace mb {

namespace {

std::string lines_of(const std::vector<Record>& records) {
  std::string lines;
  for (const Record& record : records) lines += to_line(to_json(record)) + "\n";
  return lines;
}

// The files of runs in the folder, sorted; temporary files of a run that was interrupted have other endings.
std::vector<std::filesystem::path> record_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(folder)) return files;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::filesystem::path& file = entry->path();
    if (file.extension() == ".jsonl" && is_content_hash(file.stem().string())) files.push_back(file);
  }
  if (error) throw StoreError(folder, "cannot be listed: " + error.message());
  std::ranges::sort(files);
  return files;
}

}  // namespace

Store::Store(std::filesystem::path directory) : directory_(std::move(directory)) {}

std::filesystem::path Store::file(const char* shelf, const std::string& hash, const char* ending) const {
  if (!is_content_hash(hash)) throw std::invalid_argument("store: a run is named by 32 hex digits");
  return directory_ / shelf / (hash + ending);
}

bool Store::has_trajectory(const std::string& hash) const {
  std::error_code error;
  return std::filesystem::exists(file("trajectories", hash, ".h5"), error);
}
Trajectory Store::read_trajectory(const std::string& hash) const {
  return mb::read_trajectory(file("trajectories", hash, ".h5"));
}
void Store::write_trajectory(const std::string& hash, const Trajectory& trajectory) const {
  mb::write_trajectory(file("trajectories", hash, ".h5"), trajectory);
}

bool Store::has_truth(const std::string& hash) const {
  std::error_code error;
  return std::filesystem::exists(file("truth", hash, ".h5"), error);
}
Trajectory Store::read_truth(const std::string& hash) const { return mb::read_trajectory(file("truth", hash, ".h5")); }
void Store::write_truth(const std::string& hash, const Trajectory& trajectory) const {
  mb::write_trajectory(file("truth", hash, ".h5"), trajectory);
}

bool Store::has_records(const std::string& hash) const {
  std::error_code error;
  return std::filesystem::exists(file("records", hash, ".jsonl"), error);
}
void Store::write_records(const std::string& hash, const std::vector<Record>& records) const {
  if (!std::ranges::all_of(records, [&](const Record& record) { return record.run == hash; })) {
    throw std::invalid_argument("store: a record of another run");
  }
  write_file(file("records", hash, ".jsonl"), lines_of(records));
}

RecordLines Store::read_all_records() const {
  RecordLines all;
  for (const std::filesystem::path& path : record_files(directory_ / "records")) {
    RecordLines lines = read_records(path);
    for (Record& record : lines.records) {
      if (record.run == path.stem()) {
        all.records.push_back(std::move(record));
      } else {
        all.refused.push_back({path, 0, "holds a record of another run"});
      }
    }
    std::ranges::move(lines.refused, std::back_inserter(all.refused));
  }
  return all;
}

std::vector<RefusedLine> Store::rebuild_results() const {
  RecordLines all = read_all_records();
  write_file(directory_ / "results.jsonl", lines_of(all.records));
  return std::move(all.refused);
}

}  // namespace mb
