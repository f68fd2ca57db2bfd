#include "cases/scene/read_profile.h"

#include "cases/scene/read_mesh.h"

namespace mb {

const std::vector<std::string>& profile_names() {
  static const std::vector<std::string> names{"quick", "standard", "full"};
  return names;
}

std::optional<Section> read_profile(Section& root, const std::string& name) {
  auto profiles = root.section("profile", true);
  if (!profiles) return std::nullopt;
  for (const std::string& known : profile_names()) profiles->has(known);
  auto profile = profiles->section(name, true);
  profiles->finish();
  if (profile) profile->has("duration");  // read beside those of the other profiles
  return profile;
}

std::vector<BodyDraft> bodies_in(std::optional<Section>& profile, std::vector<BodyDraft> bodies) {
  auto meshes = profile ? profile->section("resolution", true) : std::nullopt;
  if (!meshes) return bodies;
  bool all_named = true;
  for (BodyDraft& body : bodies) {
    all_named = all_named && body.name;
    const auto mesh = body.name ? meshes->section(*body.name, true) : std::nullopt;
    if (mesh) body.resolution = read_mesh(*mesh, body);
  }
  meshes->finish(all_named);
  return bodies;
}

}  // namespace mb
