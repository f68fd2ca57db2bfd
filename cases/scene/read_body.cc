#include "cases/scene/read_body.h"

#include "cases/scene/resolution.h"

namespace mb {

namespace {

const Range length_range{1e-6, 1e4, "m"};  // from a grain to a mountain

std::optional<Shape> read_shape(Section section) {
  const Words words{{"box", "cylinder", "sphere", "superquadric"}, "shape kind", "shape kinds"};
  const auto kind = section.choice("kind", words);
  if (!kind) {
    section.finish(false);
    return std::nullopt;
  }
  if (*kind == "superquadric") {
    section.error("kind", "shape kind 'superquadric' is understood, but cannot be simulated yet");
    return std::nullopt;
  }
  std::optional<Shape> shape;
  if (*kind == "box") {
    if (const auto size = section.vector("size", length_range)) shape = Box{*size};
  } else if (*kind == "cylinder") {
    const auto radius = section.number("radius", length_range);
    const auto length = section.number("length", length_range);
    if (radius && length) shape = Cylinder{*radius, *length};
  } else if (const auto radius = section.number("radius", length_range)) {
    shape = Sphere{*radius};
  }
  section.finish();
  return shape;
}

void read_kinematics(Section& section) {
  if (!section.has("kinematics")) return;
  const auto kinematics = section.choice("kinematics", {{"linear", "finite"}, "kinematics", "kinematics"});
  if (kinematics == "finite") {
    section.error("kinematics", "kinematics 'finite' is understood, but cannot be simulated yet");
  }
}

}  // namespace

BodyDraft read_body(Section section, const HistoryContext& context) {
  BodyDraft body;
  body.name = section.name("name");
  if (auto shape = section.section("shape")) body.shape = read_shape(*shape);
  if (auto material = section.section("material")) body.material = read_material(*material);
  if (auto damping = section.section("damping", true)) body.damping = read_damping(*damping);
  if (auto resolution = section.section("resolution")) body.resolution = read_resolution(*resolution, body.shape);
  body.supports = read_supports(section, body.shape, context);
  read_kinematics(section);
  for (const char* key : {"pose", "velocity", "angular_velocity"}) section.not_yet(key);
  section.finish();
  return body;
}

Body completed(const BodyDraft& draft) {
  return {draft.name.value(),   draft.shape.value(),      draft.material.value(), draft.damping.rayleigh,
          draft.damping.ratios, draft.resolution.value(), draft.supports.supports};
}

}  // namespace mb
