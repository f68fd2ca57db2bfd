#include "harness/commands/find_cases.h"

#include <algorithm>

#include "cases/scene/nearest.h"

namespace mb {

namespace {

std::filesystem::path case_folder() {
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const auto& folder : {std::filesystem::path("cases"), program / "../share/modalbench/cases"})
    if (std::filesystem::is_directory(folder, ignored)) return folder.lexically_normal();
  return {};
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

}  // namespace mb
