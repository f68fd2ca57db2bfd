#include "cases/scene/read_toml.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/check_text.h"
#include "cases/scene/read_profile.h"
#include "cases/scene/read_scene.h"
#include "cases/scene/table_file.h"

namespace mb {

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 20;

void require_profile(const std::string& profile) {
  const auto& names = profile_names();
  if (std::find(names.begin(), names.end(), profile) == names.end()) {
    throw std::invalid_argument(fmt::format("unknown profile '{}'", printable(profile)));
  }
}

}  // namespace

Scene read_toml(const std::filesystem::path& file, const Vocabulary& vocabulary, const std::string& profile) {
  require_profile(profile);
  const FileText content = read_text_file(file, most_bytes);
  if (!content.problem.empty()) {
    Findings findings(file.string(), "");
    findings.error({}, "this is no case file: " + content.problem);
    throw CaseErrors(findings.found());
  }
  return read_scene(content.text, file.string(), file.parent_path(), vocabulary, profile);
}

}  // namespace mb
