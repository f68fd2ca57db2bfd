#include "cases/scene/read_body.h"

#include <algorithm>

#include "cases/scene/read_mesh.h"
#include "cases/scene/read_shape.h"
#include "cases/scene/read_theory.h"

namespace mb {

namespace {

std::optional<Kinematics> read_kinematics(Section& section) {
  if (!section.has("kinematics")) return Kinematics::linear;
  const auto word = section.choice("kinematics", {{"linear", "finite"}, "kinematics", "kinematics"});
  if (!word) return std::nullopt;
  return *word == to_string(Kinematics::finite) ? Kinematics::finite : Kinematics::linear;
}

void check_kinematics(Section& section, const BodyDraft& body) {
  if (body.kinematics != Kinematics::finite) return;
  const auto refuse = [&](const std::string& what, const char* help) {
    section.error("kinematics", "kinematics 'finite' is of isotropic solids with Rayleigh damping: " + what, help);
  };
  if (body.theory && *body.theory != Theory::solid)
    refuse(std::string("theory '") + to_string(*body.theory) + "' is linear", "leave one of them out");
  if (body.material && body.material->orthotropy)
    refuse("[body.material] states 'orthotropy'", "state youngs_modulus and poissons_ratio");
  if (body.material && !body.material->inclusions.empty())
    refuse("[body.material] states an 'inclusion'", "leave it out");
  if (body.settled) refuse("'starts' = \"settled\" is where linear bodies come to rest", "leave one of them out");
  if (!body.damping.ratios.empty()) refuse("[body.damping] states 'ratios' of single modes", "state alpha and beta");
}

// A damper to the ground stands still beside the body: of bodies that stay where they are.
void check_dashpots(Section& section, const BodyDraft& body) {
  if (body.dashpots.at.empty()) return;
  const auto refuse = [&](const std::string& what) {
    section.findings().error(body.dashpots.at.front(),
                             "a dashpot is of solids of linear kinematics with supports: " + what);
  };
  if (body.theory && *body.theory != Theory::solid) return refuse("the body is of a theory");
  if (body.kinematics == Kinematics::finite) return refuse("the body's kinematics are finite");
  if (body.supports.supports.empty()) refuse("no support holds the body");
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
  ShapeDraft draft;
  if (auto shape = section.section("shape")) draft = read_body_shape(*shape);
  body.shape = draft.shape;
  body.of_kind = draft.of_kind;
  if (auto material = section.section("material")) body.material = read_material(*material);
  if (auto damping = section.section("damping", true)) body.damping = read_damping(*damping);
  if (auto resolution = section.section("resolution")) body.resolution = read_mesh(*resolution, body);
  body.supports = read_supports(section, draft, context);
  body.dashpots = read_dashpots(section, draft);
  body.kinematics = read_kinematics(section);
  body.pose = read_pose(section, "pose");
  body.twist = read_twist(section);
  body.settled = read_settled(section, body);
  check_theory(section, body);
  check_kinematics(section, body);
  check_dashpots(section, body);
  section.finish();
  return body;
}

Body completed(const BodyDraft& draft) {
  return {.name = draft.name.value(),
          .shape = draft.shape.value(),
          .material = draft.material.value(),
          .damping = draft.damping.rayleigh,
          .damping_ratios = draft.damping.ratios,
          .resolution = draft.resolution.value(),
          .supports = draft.supports.supports,
          .pose = draft.pose.value(),
          .twist = draft.twist.value(),
          .theory = draft.theory.value(),
          .kinematics = draft.kinematics.value(),
          .settled = draft.settled,
          .dashpots = draft.dashpots.dashpots};
}

}  // namespace mb
