// What has been computed, kept by content: a run is named by the hash of all that determines it.
//
//   STORE/trajectories/<hash>.h5   answers, of finite runs      STORE/records/<hash>.jsonl   the marks of one run
//   STORE/truth/<hash>.h5          answers of the truth         STORE/timings/<hash>.jsonl   the times of one run
//   STORE/findings/<hash>.json     tables of one analysis       STORE/results.jsonl          all marks, rebuilt
//
// Runs that failed or were unstable have records, and no trajectory: no file of these holds a number that is not finite,
// where there is none stands null. Tables may say "inf", by name: a largest stable step where none grows.
//
// Records, times and findings end in a line with the checksum of what stands before it (seal.h), .h5 files hold one;
// results.jsonl is for others to read, this program never does.
//
// Every file appears whole or not at all, one file a run: any number of processes may share a store. A damaged file is
// named and never used: compute it again and write it over (harness/study/stored.h says what of a job is there).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/contract/finding.h"
#include "cases/contract/record.h"
#include "cases/json/record_json.h"
#include "harness/store/trajectory_file.h"

namespace mb {

// Every hash is one of content_hash: anything else throws std::invalid_argument. Reading and writing throw StoreError.
class Store {
 public:
  // Nothing is made or written yet: a store may be read from a read-only disk, and may not exist before its first file.
  explicit Store(std::filesystem::path directory);
  const std::filesystem::path& directory() const { return directory_; }

  // Throw StoreError where nothing can be written there, or a folder stands where a file of that run belongs: before
  // hours are spent on what cannot be kept.
  void require_writable() const;
  void require_room(const std::string& hash) const;

  // has_...: whether the file is there, not whether it is sound.
  bool has_trajectory(const std::string& hash) const;
  Trajectory read_trajectory(const std::string& hash) const;
  void write_trajectory(const std::string& hash, const Trajectory& trajectory) const;

  bool has_truth(const std::string& hash) const;
  Trajectory read_truth(const std::string& hash) const;
  void write_truth(const std::string& hash, const Trajectory& trajectory) const;

  // Replaces what was recorded of this run, its times included; every record's `run` is the hash.
  bool has_records(const std::string& hash) const;
  void write_records(const std::string& hash, const std::vector<Record>& records) const;

  // Times of a run, apart from its marks: they may be taken later, by another process, alone. May be none.
  bool has_times(const std::string& hash) const;
  void write_times(const std::string& hash, const std::vector<Record>& times) const;
  RecordLines read_records_of(const std::string& hash) const;  // marks of one run, without its times
  RecordLines read_times_of(const std::string& hash) const;

  // Tables of one analysis of one case; every finding's `run` is the hash.
  bool has_findings(const std::string& hash) const;
  void write_findings(const std::string& hash, const std::vector<Finding>& findings) const;
  // Of one analysis, or of all; a damaged file is named in `refused`.
  struct Findings {
    std::vector<Finding> findings;
    std::vector<RefusedLine> refused;
  };
  Findings read_findings_of(const std::string& hash) const;
  Findings read_all_findings() const;

  // Marks and times, sorted by run; damaged lines, records under another run's name and runs without any are in
  // `refused`.
  RecordLines read_all_records() const;

  // results.jsonl from the files of the runs. Returns the lines that were refused and left out.
  std::vector<RefusedLine> rebuild_results() const;

 private:
  std::filesystem::path file(const char* shelf, const std::string& hash, const char* ending) const;
  std::filesystem::path directory_;
};

}  // namespace mb
