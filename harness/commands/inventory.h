// What a store holds, file by file, and which of it is still of use: whether the cases, as they are, and this build
// would make the same file again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/catalogue.h"

namespace mb {

// Which file stands at a path, as it stands: another one, or one written to since, differs.
struct Stamp {
  std::uint64_t inode = 0;
  std::int64_t written = 0;  // [ns] since the epoch
  std::int64_t size = -1;    // [byte]
  bool operator==(const Stamp&) const = default;
};
Stamp stamp_of(const std::filesystem::path& path);  // links are not followed; of nothing what no file has

struct StoredFile {
  std::filesystem::path path;
  std::string shelf;  // "trajectories", "truth", "records", "timings", "findings"; "results": results.jsonl
  std::string hash;
  double size;  // [byte]
  double age;   // [s] since it was written
  // unknown: of a case that was not found, which alone could tell whether it is current; unfinished: left behind by a
  // process that was killed while it wrote
  enum class State { current, outdated, unknown, damaged, unfinished } state;
  std::string remark;  // of damaged files the fault, of unknown ones the case's name where it is known
  Stamp stamp{};       // from before it was read
};

struct Inventory {
  std::vector<StoredFile> files;  // sorted by path
  int n_strangers = 0;            // files in the shelves which the suite did not name: never touched
};
// scenes: every known case in every profile. Symbolic links are not followed. Every file is read but outdated ones.
Inventory inventory(const std::filesystem::path& store, const std::vector<Scene>& scenes, const Catalogue& catalogue);

// "12h", "30d", "2w" in seconds; nothing for anything else: no sign, blank, fraction, zero, or more than 6 digits.
std::optional<double> parse_age(const std::string& text);

}  // namespace mb
