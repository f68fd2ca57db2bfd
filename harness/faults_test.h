// What tests of faults share: a case that is run, with a table, and what its store must hold afterwards.
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>
#include <string>
#include <vector>

#include "harness/process_test.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"

namespace mb::faults {

inline const std::vector<std::string> run{"run", "case.toml", "--untimed", "--resume"};

inline std::vector<std::string> run_with(const std::vector<std::string>& more) {
  std::vector<std::string> words = run;
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Files of the store under their final names, below it.
inline std::map<std::string, std::string> finished(const fs::path& store) {
  std::map<std::string, std::string> files;
  if (!fs::exists(store)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(store)) {
    const std::string ending = entry.path().extension();
    if (entry.is_regular_file() && (ending == ".h5" || ending == ".json" || ending == ".jsonl"))
      files[fs::relative(entry.path(), store)] = text(entry.path());
  }
  files.erase("results.jsonl");  // made of the others
  return files;
}

// Everything but the date of computation.
inline std::string timeless(std::string content) {
  for (size_t at = 0; (at = content.find("\"date\":\"", at)) != std::string::npos;)
    content.erase(at, content.find('"', at + 8) - at);
  return content.substr(0, content.rfind("{\"checksum\""));
}

// fewest_files: of the small case 4 truths, 4 answers, 4 runs and the marks of truths.
inline void expect_same_results(const fs::path& a, const fs::path& b, size_t fewest_files = 12) {
  const auto first = finished(a), second = finished(b);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_GE(first.size(), fewest_files);
  for (const auto& [name, content] : first) {
    ASSERT_TRUE(second.contains(name)) << name;
    EXPECT_TRUE(timeless(content) == timeless(second.at(name))) << name;
  }
}

// Whether every finished file is sound.
inline void expect_sound(const fs::path& directory) {
  const Store store(directory);
  for (const RefusedLine& line : store.read_all_records().refused) ADD_FAILURE() << line.file << ": " << line.reason;
  for (const RefusedLine& line : store.read_all_findings().refused) ADD_FAILURE() << line.file << ": " << line.reason;
  for (const auto& [name, content] : finished(directory)) {
    const fs::path file = name;
    if (file.parent_path() == "truth") {
      EXPECT_NO_THROW(store.read_truth(file.stem())) << name;
    } else if (file.parent_path() == "trajectories") {
      EXPECT_NO_THROW(store.read_trajectory(file.stem())) << name;
    }
  }
}

inline void expect_nothing_half_written(const fs::path& store) {
  if (!fs::exists(store)) return;
  for (const auto& entry : fs::recursive_directory_iterator(store)) {
    const std::string ending = entry.path().extension();
    EXPECT_TRUE(entry.is_directory() || ending == ".h5" || ending == ".jsonl" || ending == ".json")
        << entry.path() << " is left behind";
  }
}

inline std::string analysed_case() {
  std::string all = small_case();
  const std::string modes = "modes = [4, 12]";
  return all.replace(all.find(modes), modes.size(), modes + "\nanalyses = [\"probe-extremes\"]");
}

// The small case with other full-order runs.
inline std::string with_rivals(int degree, const std::string& cells, const std::string& time_steps) {
  std::string all = small_case();
  const std::string rivals = "degrees = [1]\ncells = [[1, 2]]\ntime_steps = [0.01, 0.005]";
  return all.replace(all.find(rivals), rivals.size(),
                     fmt::format("degrees = [{}]\ncells = [{}]\ntime_steps = [{}]", degree, cells, time_steps));
}

}  // namespace mb::faults
