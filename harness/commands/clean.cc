#include <fmt/ostream.h>

#include <algorithm>
#include <map>
#include <set>

#include "cases/scene/printable.h"
#include "harness/commands/bytes.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/commands/inventory.h"
#include "harness/store/store.h"

namespace mb {

namespace {

namespace fs = std::filesystem;
using State = StoredFile::State;

constexpr std::size_t most_shown = 4096;  // [characters] of a path

struct Total {
  int n = 0;
  double size = 0;  // [byte]
  void add(const StoredFile& file) { ++n, size += file.size; }
};

// Every case that is found, and the files given, in every profile. A wrong file's results are of an unknown case.
std::vector<Scene> known_scenes(const CleanOptions& options, const Catalogue& catalogue, std::ostream& err) {
  std::vector<std::string> files = options.cases;
  for (const auto& file : all_cases()) files.push_back(file.string());
  std::vector<Scene> scenes;
  NamedFiles named;
  for (const auto& file : find_cases(files)) try {
      for (const char* profile : {"quick", "standard", "full"})
        scenes.push_back(read_toml(file, catalogue.vocabulary(), profile));
      named.emplace_back(scenes.back().name, file);
    } catch (const CaseErrors&) {
      if (std::ranges::any_of(options.cases, [&](const auto& name) { return find_case(name) == file; })) throw;
      fmt::print(err, "{} is no valid case: its results are kept\n", printable(file.string(), most_shown));
    }
  require_names_of_their_own(named);
  return scenes;
}

// Why a file goes; empty where it stays.
std::string reason(const StoredFile& file, std::optional<double> oldest, const std::string& older) {
  if (file.state == State::damaged) return "damaged";
  if (file.state == State::unfinished) return "left behind by a process that was killed";
  if (file.state == State::outdated && file.shelf == "findings")  // nothing in a table says which study it is of
    return "tables of a case or build that is no longer so, or of other settings, as `run --set` has them";
  if (file.state == State::outdated) return "of a case, settings or build that is no longer so";
  return oldest && file.age > *oldest ? "older than " + older : "";
}

void print_line(std::ostream& out, const std::string& what, const Total& total) {
  fmt::print(out, "  {:>6} file{} {:>9}  {}\n", total.n, total.n == 1 ? " " : "s", bytes(total.size), what);
}

void print_holdings(const CleanOptions& options, const Inventory& all, std::ostream& out) {
  std::map<std::string, Total> by_shelf;
  for (const char* shelf : {"findings", "records", "timings", "trajectories", "truth"}) by_shelf[shelf];
  Total whole;
  for (const StoredFile& file : all.files) by_shelf[file.shelf].add(file), whole.add(file);
  fmt::print(out, "{} holds\n", options.store);
  for (const auto& [shelf, total] : by_shelf) print_line(out, shelf, total);
  print_line(out, "in all", whole);
}

void print_kept_unknown(const Inventory& all, std::ostream& err) {
  std::set<std::string> names;
  int n = 0;
  for (const StoredFile& file : all.files) {
    n += file.state == State::unknown;
    if (file.state == State::unknown && !file.remark.empty()) names.insert(file.remark);
  }
  for (const std::string& name : names)
    fmt::print(err, "case '{}' is not found here: name its file to have its results looked at\n", name);
  if (n > 0) fmt::print(err, "{} files are or may be of cases not found: kept unless older than asked for\n", n);
  if (all.n_strangers > 0) fmt::print(err, "{} files that are not ours: left alone\n", all.n_strangers);
}

// Number of files that could not be removed. A run may have written one anew since it was read.
int remove_all(const std::vector<StoredFile>& files, std::ostream& err) {
  int n_failed = 0;
  for (const StoredFile& file : files) {
    if (const Stamp now = stamp_of(file.path); now != Stamp() && now != file.stamp) {
      fmt::print(err, "{}: written meanwhile: stays\n", printable(file.path.string(), most_shown));
      continue;
    }
    std::error_code error;
    fs::remove(file.path, error);
    if (!error) continue;
    fmt::print(err, "{}: cannot be removed: {}\n", printable(file.path.string(), most_shown), error.message());
    ++n_failed;
  }
  return n_failed;
}

}  // namespace

int clean_command(const CleanOptions& options, const Catalogue& catalogue, const Console& console) {
  const std::optional<double> oldest = parse_age(options.older);
  if (!options.older.empty() && !oldest)
    throw UsageError("--older " + options.older + ": must be a number of hours, days or weeks, as 12h, 30d, 2w");
  if (!fs::is_directory(options.store)) throw UsageError("no store at '" + options.store + "'");
  const Inventory all = inventory(options.store, known_scenes(options, catalogue, console.err), catalogue);
  print_holdings(options, all, console.out);

  std::vector<StoredFile> going;
  std::map<std::string, Total> by_reason;
  for (const StoredFile& file : all.files) {
    const std::string why = reason(file, oldest, options.older);
    if (why.empty()) continue;
    going.push_back(file);
    by_reason[why].add(file);
    if (file.state == State::damaged)
      fmt::print(console.err, "damaged: {}: {}\n", printable(file.path.string(), most_shown),
                 printable(file.remark, most_shown));
  }
  print_kept_unknown(all, console.err);
  fmt::print(console.out, "{}\n", going.empty() ? "nothing goes" : options.yes ? "goes" : "would go");
  for (const auto& [why, total] : by_reason) print_line(console.out, why, total);
  if (going.empty()) return 0;
  if (!options.yes) {
    fmt::print(console.err, "nothing was deleted: --yes does\n");
    return 0;
  }
  const int n_failed = remove_all(going, console.err);
  Store(options.store).rebuild_results();
  return n_failed == 0 ? 0 : 2;
}

}  // namespace mb
