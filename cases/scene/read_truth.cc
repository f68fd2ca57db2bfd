#include "cases/scene/read_truth.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/closed_form.h"
#include "cases/scene/read_mesh.h"

namespace mb {

namespace {

struct Mesh {
  std::optional<Resolution> resolution;
  Position where;
};

// The mesh in `key` of [truth], or that of the profile in its place.
Mesh read_mesh(Section& truth, std::optional<Section>& profile, const std::string& key, const BodyDraft& body) {
  const auto base = truth.section(key);
  Mesh mesh{base ? read_mesh(*base, body) : std::nullopt, truth.where(key)};
  const auto other = profile ? profile->section(key, true) : std::nullopt;
  return other ? Mesh{read_mesh(*other, body), profile->where(key)} : mesh;
}

// Errors stand at what the profile states, where it does.
void check_meshes(const Mesh& finer, const Mesh& coarser, std::optional<Section>& profile, const BodyDraft& body,
                  Findings& findings) {
  const bool own_finer = profile && profile->has("finer");
  if (finer.resolution && coarser.resolution && *finer.resolution == *coarser.resolution) {
    const bool own_coarser = profile && profile->has("coarser");
    findings.error(own_finer && !own_coarser ? finer.where : coarser.where,
                   "'coarser' equals 'finer': their distance is the error bar, and would be 0");
  }
  if (finer.resolution && body.resolution && *finer.resolution == *body.resolution) {
    const bool own_mesh = profile && profile->has("resolution") && !own_finer;
    findings.error(
        own_mesh ? profile->where("resolution") : finer.where,
        fmt::format("'finer' is the mesh of body '{}' itself: truth same_mesh has that one", body.name.value_or("")));
  }
}

}  // namespace

TruthDraft read_truth(Section section, std::optional<Section>& profile, const std::vector<BodyDraft>& bodies) {
  const BodyDraft body = bodies.empty() ? BodyDraft{} : bodies.front();
  const auto tolerance = section.number("relative_tolerance", {1e-12, 1e-2});
  const Mesh finer = read_mesh(section, profile, "finer", body);
  const Mesh coarser = read_mesh(section, profile, "coarser", body);
  TruthDraft draft{std::nullopt, section.has("exact"), section.where("exact")};
  std::optional<std::string> exact = "";
  if (draft.has_exact) exact = section.choice("exact", {closed_form_names(), "closed form", "closed forms"});
  section.finish();
  check_meshes(finer, coarser, profile, body, section.findings());
  if (tolerance && finer.resolution && coarser.resolution && exact) {
    draft.settings = TruthSettings{*tolerance, *finer.resolution, *coarser.resolution, *exact};
  }
  return draft;
}

ReferenceFrequencies read_reference_frequencies(Section section) {
  ReferenceFrequencies reference;
  reference.hertz = section.numbers("hertz", {0, 1e12, "1/s", true}, {1, 256}).value_or(std::vector<double>{});
  reference.uncertainty = section.number("uncertainty", {0, 1}, 0);
  section.finish();
  const auto& hertz = reference.hertz;
  const auto lower = std::is_sorted_until(hertz.begin(), hertz.end());
  if (lower != hertz.end()) {
    section.error("hertz", fmt::format("'hertz' must ascend: {} follows {}", *lower, *(lower - 1)));
  }
  return reference;
}

}  // namespace mb
