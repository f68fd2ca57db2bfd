#include "cases/scene/keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/key_tables.h"
#include "cases/scene/read_profile.h"

namespace mb {

namespace {

// Tables of the same keys: where they stand, and where their keys are documented. Longest first where one begins
// another.
struct Alias {
  std::string_view path, documented;
};
constexpr Alias aliases[] = {{"load.history", "history"},
                             {"body.support.acceleration", "history"},
                             {"body.support.disc", "disc"},
                             {"load.traction.disc", "disc"},
                             {"body.pose", "pose"},
                             {"obstacle.pose", "pose"},
                             {"body.resolution", "mesh"},
                             {"truth.finer", "mesh"},
                             {"truth.coarser", "mesh"},
                             {"profile.NAME.finer", "mesh"},
                             {"profile.NAME.coarser", "mesh"},
                             {"profile.NAME.resolution.BODY", "mesh"},
                             {"profile.NAME.rival", "study.rival"},
                             {"profile.NAME.stepping", "study.stepping"},
                             {"mesh.others.BODY", "mesh"}};

// Puts BODY in the place of the name that follows `before`.
void hide_name(std::string& path, std::string_view before) {
  const std::size_t at = path.find(before);
  if (at == std::string::npos) return;
  const std::size_t name = at + before.size();
  path.replace(name, std::min(path.find('.', name), path.size()) - name, "BODY");
}

// profile.quick.resolution.cylinder.cells -> profile.NAME.resolution.BODY.cells
std::string with_placeholders(std::string path) {
  for (const std::string& name : profile_names()) {
    const std::string prefix = "profile." + name;
    if (path != prefix && !path.starts_with(prefix + ".")) continue;
    path.replace(0, prefix.size(), "profile.NAME");
    if (path.starts_with("profile.NAME.resolution.")) hide_name(path, "profile.NAME.resolution.");
  }
  hide_name(path, ".others.");
  return path;
}

std::string documented_path(std::string path) {
  for (const Alias& alias : aliases) {
    const std::string prefix = std::string(alias.path) + ".";
    if (path.starts_with(prefix)) path = std::string(alias.documented) + "." + path.substr(prefix.size());
  }
  return path;
}

}  // namespace

std::string takes(const KeyDoc& key) {
  std::string text = key.type;
  if (!key.range.empty()) text += (key.range.find_first_of("[(") == 0 ? " in " : ", ") + key.range;
  if (!key.unit.empty()) text += (key.range.find_first_of("[(") == 0 ? " " : ", ") + key.unit;
  return text;
}

const std::vector<KeyGroup>& key_groups() {
  static const std::vector<KeyGroup> all = [] {
    std::vector<KeyGroup> groups = scene_keys();
    groups.insert(groups.end(), study_keys().begin(), study_keys().end());
    return groups;
  }();
  return all;
}

const KeyDoc* find_key(std::string_view path) {
  const std::string sought = documented_path(with_placeholders(std::string(path)));
  for (const KeyGroup& group : key_groups()) {
    for (const KeyDoc& key : group.keys) {
      if (key.path == sought) return &key;
    }
  }
  return nullptr;
}

std::string markdown_table(const KeyGroup& group) {
  std::string out = "| key | takes | default | meaning |\n|---|---|---|---|\n";
  for (const KeyDoc& key : group.keys) {
    out += fmt::format("| `{}` | {} | {} | {} |\n", key.path, takes(key), key.fallback, key.meaning);
  }
  return out;
}

}  // namespace mb
