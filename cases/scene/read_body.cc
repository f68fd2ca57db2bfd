#include "cases/scene/read_body.h"

#include <algorithm>

#include "cases/scene/read_mesh.h"
#include "cases/scene/read_shape.h"
#include "cases/scene/read_theory.h"

namespace mb {

namespace {

void read_kinematics(Section& section) {
  if (!section.has("kinematics")) return;
  const auto kinematics = section.choice("kinematics", {{"linear", "finite"}, "kinematics", "kinematics"});
  if (kinematics == "finite") {
    section.error("kinematics", "kinematics 'finite' is understood, but cannot be simulated yet");
  }
}

// A body that nothing holds falls, however it starts.
bool read_settled(Section& section, const BodyDraft& body) {
  if (!section.has("starts")) return false;
  const auto word = section.choice("starts", {{"undeformed", "settled"}, "state at the start", "states at the start"});
  if (word != "settled") return false;
  if (body.supports.supports.empty() && body.theory == Theory::solid)
    section.error("starts", "'starts' = \"settled\" is of no use: no support holds the body, its weight lets it fall");
  return true;
}

}  // namespace

std::optional<bool> touch(const std::vector<BodyDraft>& bodies) {
  const auto count = [&](bool touches) {
    return std::count_if(bodies.begin(), bodies.end(), [&](const auto& body) { return body.touches == touches; });
  };
  if (count(true) > 0) return true;
  if (bodies.empty() || count(false) < std::ssize(bodies)) return std::nullopt;
  return false;
}

BodyDraft read_body(Section section, const HistoryContext& context) {
  BodyDraft body;
  body.name = section.name("name");
  body.theory = read_theory(section);
  if (auto shape = section.section("shape")) body.shape = read_body_shape(*shape);
  if (auto material = section.section("material")) body.material = read_material(*material);
  if (auto damping = section.section("damping", true)) body.damping = read_damping(*damping);
  if (auto resolution = section.section("resolution")) body.resolution = read_mesh(*resolution, body);
  body.supports = read_supports(section, body.shape, context);
  read_kinematics(section);
  body.pose = read_pose(section, "pose");
  body.twist = read_twist(section);
  body.settled = read_settled(section, body);
  check_theory(section, body);
  section.finish();
  return body;
}

Body completed(const BodyDraft& draft) {
  return {draft.name.value(),      draft.shape.value(),  draft.material.value(),
          draft.damping.rayleigh,  draft.damping.ratios, draft.resolution.value(),
          draft.supports.supports, draft.pose.value(),   draft.twist.value(),
          draft.theory.value(),    draft.settled};
}

}  // namespace mb
