#include "harness/commands/inventory.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <regex>
#include <set>

#include "harness/store/hash.h"
#include "harness/store/store.h"
#include "harness/study/identity.h"
#include "harness/study/plan.h"

namespace mb {

namespace {

namespace fs = std::filesystem;
using State = StoredFile::State;

struct Shelf {
  const char *name, *ending;
};
constexpr Shelf shelves[] = {
    {"findings", ".json"}, {"records", ".jsonl"}, {"timings", ".jsonl"}, {"trajectories", ".h5"}, {"truth", ".h5"}};

// A file of FILE.XXXXXX, which write_file renames to FILE at its end, is in use for as long as a run may write.
constexpr double longest_write = 3600;  // [s]

// What the scenes call for, by name.
class Wanted {
 public:
  Wanted(const std::vector<Scene>& scenes, const Catalogue& catalogue) {
    for (const Scene& scene : scenes) {
      scenes_.insert({{scene.name, scene.profile}, scene});
      for (const Job& job : jobs(scene, catalogue)) hashes_.insert(job.hash);
      for (const Contender& truth : truth_contenders(scene)) hashes_.insert(run_hash(scene, truth));
      hashes_.merge(truth_hashes(scene));
    }
  }
  bool contains(const std::string& hash) const { return hashes_.contains(hash); }
  bool knows(const std::string& name) const {
    return std::any_of(scenes_.begin(), scenes_.end(), [&](const auto& entry) { return entry.first.first == name; });
  }
  // Runs that --set asked for are in no plan, but are current all the same.
  bool is_current(const Record& record) const {
    if (contains(record.run)) return true;
    const auto scene = scenes_.find({record.case_name, record.profile});
    return scene != scenes_.end() && run_hash(scene->second, record.contender) == record.run;
  }

 private:
  std::map<std::pair<std::string, std::string>, Scene> scenes_;
  std::set<std::string> hashes_;
};

struct Verdict {
  State state;
  std::string remark;
  bool may_be_of_others = false;  // no record says whose it is, and truths of the same physics are one file
};

class Survey {
 public:
  Survey(const fs::path& directory, const Wanted& wanted) : store_(directory), wanted_(wanted) {
    RecordLines records = store_.read_all_records();
    for (const Record& record : records.records)
      runs_.insert({record.run, judge(wanted_.is_current(record), record.case_name)});
    Store::Findings findings = store_.read_all_findings();
    for (const Finding& finding : findings.findings)
      runs_.insert({finding.run, judge(wanted_.contains(finding.run), finding.case_name)});
    for (const auto* refused : {&records.refused, &findings.refused})
      for (const RefusedLine& line : *refused) damaged_.insert({line.file, line.reason});
  }

  // Of truths, and of trajectories whose run has no record, the file says whose it is.
  Verdict of(const fs::path& path, const std::string& shelf, const std::string& hash) const {
    if (const auto it = damaged_.find(path); it != damaged_.end()) return {State::damaged, it->second};
    Verdict verdict{State::outdated, "", true};
    if (wanted_.contains(hash)) verdict = {State::current, ""};
    if (const auto run = runs_.find(hash); run != runs_.end() && shelf != "truth") verdict = run->second;
    const bool goes = verdict.state == State::outdated && !verdict.may_be_of_others;
    if (goes || !path.extension().string().ends_with("h5")) return verdict;
    try {
      const Trajectory held = shelf == "truth" ? store_.read_truth(hash) : store_.read_trajectory(hash);
      const bool is_strange = !held.case_name.empty() && !wanted_.knows(held.case_name);
      return verdict.may_be_of_others && is_strange ? Verdict{State::unknown, held.case_name} : verdict;
    } catch (const StoreError& error) {
      return {State::damaged, error.fault()};
    }
  }

 private:
  Verdict judge(bool current, const std::string& name) const {
    if (current) return {State::current, ""};
    return wanted_.knows(name) ? Verdict{State::outdated, ""} : Verdict{State::unknown, name};
  }

  Store store_;
  const Wanted& wanted_;
  std::map<std::string, Verdict> runs_;
  std::map<fs::path, std::string> damaged_;
};

// The hash of "HASH" + ending + ".XXXXXX", or nothing.
std::string unfinished_hash(const std::string& name, const std::string& ending) {
  if (name.size() != 32 + ending.size() + 7 || name.substr(32, ending.size() + 1) != ending + ".") return "";
  return is_content_hash(name.substr(0, 32)) ? name.substr(0, 32) : "";
}

double age_of(const fs::path& path) {
  std::error_code error;
  const auto written = fs::last_write_time(path, error);
  return error ? 0 : std::chrono::duration<double>(fs::file_time_type::clock::now() - written).count();
}

// Adds to `doubtful` what may be of a case that was not found: places in `all`.
void take(Inventory& all, const fs::path& path, const Stamp& stamp, const Shelf& shelf, const Survey& survey,
          std::vector<std::size_t>& doubtful) {
  StoredFile file{path,         shelf.name,     path.stem(), static_cast<double>(stamp.size),
                  age_of(path), State::current, "",          stamp};
  if (const auto hash = unfinished_hash(path.filename(), shelf.ending); !hash.empty() && file.age > longest_write) {
    file.hash = hash;
    file.state = State::unfinished;
  } else if (path.extension() == shelf.ending && is_content_hash(file.hash)) {
    const Verdict verdict = survey.of(path, shelf.name, file.hash);
    file.state = verdict.state;
    file.remark = verdict.remark;
    if (verdict.may_be_of_others) doubtful.push_back(all.files.size());
  } else {
    ++all.n_strangers;
    return;
  }
  all.files.push_back(file);
}

// Of a process that was killed: "results.jsonl.XXXXXX" and what tells that a store can be written, "probe.PID".
bool is_left_over(const std::string& name) {
  static const std::regex form("results\\.jsonl\\..{6}|probe\\.[0-9]+(\\..{6})?");
  return std::regex_match(name, form);
}

void take_left_overs(Inventory& all, const fs::path& store) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(store, error)) {
    if (!fs::is_regular_file(entry.symlink_status()) || !is_left_over(entry.path().filename())) continue;
    const Stamp stamp = stamp_of(entry.path());
    StoredFile file{entry.path(),         "results",         "", static_cast<double>(stamp.size),
                    age_of(entry.path()), State::unfinished, "", stamp};
    if (file.age > longest_write) all.files.push_back(file);
  }
}

using Stamps = std::map<fs::path, Stamp>;  // of regular files; of others none that a file has

Stamps stamps_in(const fs::path& folder) {
  Stamps all;
  if (!fs::is_directory(fs::symlink_status(folder))) return all;
  for (const auto& entry : fs::directory_iterator(folder))
    all[entry.path()] = fs::is_regular_file(entry.symlink_status()) ? stamp_of(entry.path()) : Stamp();
  return all;
}

}  // namespace

Stamp stamp_of(const fs::path& path) {
  struct stat found {};
  if (::lstat(path.c_str(), &found) != 0) return {};
  return {found.st_ino, found.st_mtim.tv_sec * 1'000'000'000 + found.st_mtim.tv_nsec, found.st_size};
}

// What is written while all is read is not looked at.
Inventory inventory(const fs::path& store, const std::vector<Scene>& scenes, const Catalogue& catalogue) {
  std::vector<Stamps> stamps;
  for (const Shelf& shelf : shelves) stamps.push_back(stamps_in(store / shelf.name));
  const Wanted wanted(scenes, catalogue);
  const Survey survey(store, wanted);
  Inventory all;
  std::vector<std::size_t> doubtful;
  for (std::size_t i = 0; i < std::size(shelves); ++i)
    for (const auto& [path, stamp] : stamps[i]) {
      if (stamp == Stamp())
        ++all.n_strangers;
      else
        take(all, path, stamp, shelves[i], survey, doubtful);
    }
  const auto is_unknown = [](const StoredFile& file) { return file.state == State::unknown; };
  if (std::ranges::any_of(all.files, is_unknown))
    for (const std::size_t i : doubtful)
      if (all.files[i].state == State::outdated) all.files[i].state = State::unknown;
  take_left_overs(all, store);
  std::sort(all.files.begin(), all.files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return all;
}

std::optional<double> parse_age(const std::string& text) {
  if (text.size() < 2 || text.size() > 7 || !std::isdigit(static_cast<unsigned char>(text[0]))) return {};
  int count = 0;
  const char* const end = text.data() + text.size() - 1;
  if (const auto [rest, error] = std::from_chars(text.data(), end, count); error != std::errc() || rest != end)
    return {};
  const double unit = text.back() == 'h' ? 3600 : text.back() == 'd' ? 86'400 : text.back() == 'w' ? 604'800 : 0;
  if (count == 0 || unit == 0) return {};
  return count * unit;
}

}  // namespace mb
