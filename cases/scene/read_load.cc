#include "cases/scene/read_load.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/read_patch.h"

namespace mb {

namespace {

// Beyond the stiffest material's modulus no strain is small.
const Range traction_range{-1e13, 1e13, "Pa"};

const BodyDraft* read_body_reference(Section& section, const std::vector<BodyDraft>& bodies) {
  Words words{{}, "body", "bodies"};
  bool all_named = true;
  for (const BodyDraft& body : bodies) {
    if (body.name) words.known.push_back(*body.name);
    all_named = all_named && body.name;
  }
  if (!all_named && section.has("body")) return nullptr;  // it may be the one whose name is wrong
  const auto name = section.choice("body", words);
  for (const BodyDraft& body : bodies) {
    if (name && body.name == name) return &body;
  }
  return nullptr;
}

std::optional<Vector3d> pressure_on(Section& section, const std::optional<Patch>& patch,
                                    const std::optional<Shape>& shape) {
  const auto pressure = section.number("pressure", traction_range);
  if (!pressure || !patch || !shape) return std::nullopt;
  if (is_plane(*shape, patch->face)) return Vector3d(-*pressure * plane_normal(*shape, patch->face));
  section.error("pressure", "pressure on a curved face is understood, but cannot be simulated yet",
                "give 'traction', the same vector everywhere on the face");
  return std::nullopt;
}

std::optional<Vector3d> read_force(Section& section, const std::optional<Patch>& patch,
                                   const std::optional<Shape>& shape) {
  const bool has_traction = section.has("traction");
  const bool has_pressure = section.has("pressure");
  if (has_traction && has_pressure) {
    section.error("pressure",
                  fmt::format("{} has both 'traction' and 'pressure': exactly one of them", section.title()));
    return std::nullopt;
  }
  if (has_pressure) return pressure_on(section, patch, shape);
  const auto traction = section.vector("traction", traction_range);
  if (!traction || !traction->isZero(0)) return traction;
  section.error("traction", "'traction' is zero: it loads nothing");
  return std::nullopt;
}

// A traction on a support does no work where the support prescribes the same component.
void check_against_supports(Section& section, const Traction& traction, const BodyDraft& body) {
  for (const Support& support : body.supports) {
    if (support.patch.face != traction.patch.face || support.patch.disc || support.kind == Support::Kind::mean)
      continue;
    if (support.kind == Support::Kind::sliding) {
      const Vector3d normal = plane_normal(*body.shape, support.patch.face);
      if (!traction.traction.cross(normal).isZero(0)) continue;
    }
    section.error("face", fmt::format("the traction on face '{}' does no work: a {} support holds that face",
                                      support.patch.face, support.kind == Support::Kind::fixed ? "fixed" : "sliding"));
  }
}

std::optional<Traction> read_traction(Section section, const std::vector<BodyDraft>& bodies) {
  const BodyDraft* body = read_body_reference(section, bodies);
  const std::optional<Shape> shape = body == nullptr ? std::nullopt : body->shape;
  const auto patch = read_patch(section, shape);
  const auto force = read_force(section, patch, shape);
  section.finish();
  if (!patch || !force) return std::nullopt;
  Traction traction{*body->name, *patch, *force};
  check_against_supports(section, traction, *body);
  return traction;
}

}  // namespace

std::optional<Load> read_load(Section section, const std::vector<BodyDraft>& bodies, const HistoryContext& context) {
  const auto name = section.name("name");
  const auto history_section = section.section("history");
  const auto history = history_section ? read_history(*history_section, context) : std::nullopt;
  auto traction_sections = section.sections("traction", {1, 64});
  std::vector<Traction> tractions;
  for (Section& entry : traction_sections) {
    if (auto traction = read_traction(entry, bodies)) tractions.push_back(std::move(*traction));
  }
  section.finish();
  if (!name || !history) return std::nullopt;
  return Load{*name, *history, std::move(tractions)};
}

std::optional<Probe> read_probe(Section section, const std::vector<BodyDraft>& bodies) {
  const auto name = section.name("name");
  const BodyDraft* body = read_body_reference(section, bodies);
  const auto point = section.vector("point", {-1e4, 1e4, "m"});
  auto direction = section.vector("direction", {-1e6, 1e6});
  section.finish();
  if (direction && direction->norm() < 1e-6) {  // below, its digits are mostly rounding of what was meant to be zero
    section.error("direction", "'direction' is zero: it points nowhere");
    direction.reset();
  }
  if (point && body != nullptr && body->shape && !contains(*body->shape, *point, placement_tolerance(*body->shape))) {
    section.error("point", fmt::format("the probe lies outside body '{}'", *body->name));
  }
  if (!name || body == nullptr || !point || !direction) return std::nullopt;
  return Probe{*name, *body->name, *point, direction->normalized()};
}

}  // namespace mb
