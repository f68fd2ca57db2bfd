#include "cases/scene/read_load.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/read_direction.h"
#include "cases/scene/read_patch.h"

namespace mb {

namespace {

// Beyond the stiffest material's modulus no strain is small.
const Range traction_range{-1e13, 1e13, "Pa"};

const BodyDraft* read_body_reference(Section& section, const std::vector<BodyDraft>& bodies) {
  const auto name = read_reference(section, "body", names_of(bodies), "body", "bodies");
  for (const BodyDraft& body : bodies) {
    if (name && body.name == name) return &body;
  }
  return nullptr;
}

struct Force {
  Vector3d traction;
  double pressure;
};

std::optional<Force> read_force(Section& section) {
  const bool has_traction = section.has("traction");
  const bool has_pressure = section.has("pressure");
  if (has_traction && has_pressure) {
    section.error("pressure",
                  fmt::format("{} has both 'traction' and 'pressure': exactly one of them", section.title()));
    return std::nullopt;
  }
  const char* key = has_pressure ? "pressure" : "traction";
  const auto pressure = has_pressure ? section.number(key, traction_range) : std::optional(0.0);
  const auto traction = has_pressure ? std::optional<Vector3d>(Vector3d::Zero()) : section.vector(key, traction_range);
  if (!pressure || !traction) return std::nullopt;
  if (*pressure != 0 || !traction->isZero(0)) return Force{*traction, *pressure};
  section.error(key, fmt::format("'{}' is zero: it loads nothing", key));
  return std::nullopt;
}

// Whether a support leaves the face free to move in a direction that the traction has.
bool does_work(const Traction& traction, const Support& support, const Shape& shape) {
  using Kind = Support::Kind;
  if (support.kind == Kind::fixed || support.kind == Kind::driven) return false;
  if (support.kind == Kind::mean) return true;
  const Vector3d normal = plane_normal(shape, support.patch.face);
  if (support.kind == Kind::sliding) return !traction.traction.cross(normal).isZero(0);  // pressure has no such part
  return traction.pressure != 0 || traction.traction.dot(normal) != 0;
}

void check_against_supports(Section& section, const Traction& traction, const BodyDraft& body) {
  for (const Support& support : body.supports.supports) {
    if (support.patch.face != traction.patch.face || support.patch.disc) continue;
    if (does_work(traction, support, *body.of_kind)) continue;
    section.error("face", fmt::format("the {} on face '{}' does no work: a {} support holds that face",
                                      traction.pressure != 0 ? "pressure" : "traction", support.patch.face,
                                      to_string(support.kind)));
  }
}

std::optional<Traction> read_traction(Section section, const std::vector<BodyDraft>& bodies) {
  const BodyDraft* body = read_body_reference(section, bodies);
  const auto patch = read_patch(section, body == nullptr ? ShapeDraft{} : ShapeDraft{body->shape, body->of_kind});
  const auto force = read_force(section);
  section.finish();
  if (!patch || !force) return std::nullopt;
  Traction traction{*body->name, *patch, force->traction, force->pressure};
  check_against_supports(section, traction, *body);
  return traction;
}

bool read_follows(Section& section) {
  return section.has("axes") && section.choice("axes", {{"start", "body"}, "axes", "axes"}) == "body";
}

void check_turning(Section& section, const std::vector<Traction>& tractions, const std::vector<BodyDraft>& bodies) {
  for (const BodyDraft& body : bodies) {
    const bool loaded = std::ranges::any_of(tractions, [&](const Traction& t) { return t.body == body.name; });
    const bool turns = body.supports.supports.empty() && body.kinematics != Kinematics::linear;
    if (!loaded || turns) continue;
    section.error("axes", fmt::format("loads turn with free bodies of finite kinematics: '{}' is none", *body.name),
                  "leave it out");
  }
}

}  // namespace

std::optional<Load> read_load(Section section, const std::vector<BodyDraft>& bodies, const HistoryContext& context,
                              Names& names) {
  const auto name = section.name("name");
  names.add(section, name);
  const bool follows = read_follows(section);
  const auto history_section = section.section("history");
  const auto history = history_section ? read_history(*history_section, context) : std::nullopt;
  auto traction_sections = section.sections("traction", {1, 64});
  std::vector<Traction> tractions;
  for (Section& entry : traction_sections) {
    if (auto traction = read_traction(entry, bodies)) tractions.push_back(std::move(*traction));
  }
  if (follows) check_turning(section, tractions, bodies);
  section.finish();
  if (!name || !history) return std::nullopt;
  return Load{*name, *history, std::move(tractions), follows};
}

std::optional<Probe> read_probe(Section section, const std::vector<BodyDraft>& bodies, Names& names) {
  const auto name = section.name("name");
  names.add(section, name);
  const BodyDraft* body = read_body_reference(section, bodies);
  const auto point = section.vector("point", {-1e4, 1e4, "m"});
  const auto direction = read_direction(section, "direction");
  section.finish();
  if (point && body != nullptr && body->shape && !contains(*body->shape, *point, placement_tolerance(*body->shape))) {
    section.error("point", fmt::format("the probe lies outside body '{}'", *body->name));
  }
  if (!name || body == nullptr || !point || !direction) return std::nullopt;
  return Probe{*name, *body->name, *point, *direction};
}

}  // namespace mb
