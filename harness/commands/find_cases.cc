#include "harness/commands/find_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "cases/scene/nearest.h"
#include "cases/scene/printable.h"

namespace mb {

namespace {

std::filesystem::path case_folder() {
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const auto& folder : {std::filesystem::path("cases"), program / "../share/modalbench/cases"})
    if (std::filesystem::is_directory(folder, ignored)) return folder.lexically_normal();
  return {};
}

// One name for whatever leads to a file.
std::filesystem::path identity_of(const std::filesystem::path& file) {
  std::error_code error;
  const auto path = std::filesystem::weakly_canonical(file, error);
  return error ? file : path;
}

}  // namespace

std::vector<std::filesystem::path> all_cases() {
  std::vector<std::filesystem::path> files;
  const auto folder = case_folder();
  std::error_code ignored;
  for (const auto& part : {folder, folder / "hard"}) {
    if (folder.empty() || !std::filesystem::is_directory(part, ignored)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(part))
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::ranges::sort(files, {}, [](const auto& file) { return file.stem(); });
  return files;
}

std::filesystem::path find_case(const std::string& name_or_file) {
  if (name_or_file.ends_with(".toml")) return name_or_file;
  std::vector<std::string> names;
  for (const auto& file : all_cases()) {
    if (file.stem() == name_or_file) return file;
    names.push_back(file.stem());
  }
  if (names.empty())
    throw UnknownCase("unknown case '" + name_or_file +
                      "': no case files in folder 'cases' here or beside the program");
  throw UnknownCase("unknown case '" + name_or_file + "'; " + suggestion(name_or_file, names, "cases"));
}

std::vector<std::filesystem::path> find_cases(const std::vector<std::string>& names_or_files) {
  std::vector<std::filesystem::path> files;
  std::set<std::filesystem::path> known;
  for (const auto& name : names_or_files) {
    const auto file = find_case(name);
    if (known.insert(identity_of(file)).second) files.push_back(file);
  }
  return files;
}

void require_names_of_their_own(const NamedFiles& files) {
  constexpr std::size_t most_shown = 4096;  // [characters] of a path
  std::map<std::string, std::filesystem::path> first;
  std::string shared;
  for (const auto& [name, file] : files) {
    const auto& other = first.try_emplace(name, file).first->second;
    if (identity_of(other) == identity_of(file)) continue;
    shared += fmt::format("{}{} and {} are both named '{}'", shared.empty() ? "" : "; ",
                          printable(other.string(), most_shown), printable(file.string(), most_shown), name);
  }
  if (!shared.empty())
    throw UsageError(shared + ": results are kept by the name of their case; give each a name of its own");
}

}  // namespace mb
