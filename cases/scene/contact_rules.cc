#include "cases/scene/contact_rules.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/number_text.h"
#include "cases/scene/read_mesh.h"

namespace mb {

namespace {

void refuse_without_contact(Section& section, const char* key) {
  if (!section.has(key)) return;
  section.findings().error(section.where_key(key),
                           fmt::format("'{}' in {}: only scenes with contact take it", key, section.title()),
                           "tables [[obstacle]] and [[contact]] state contact");
}

void refuse_with_contact(Findings& findings, const Position& where, const std::string& what) {
  findings.error(where, what + " is understood, but cannot be simulated yet together with contact");
}

bool states_any(Section& section, const char* key) { return section.has(key) && !section.is_empty_array(key); }

// Supports hold some points of a body from the start: all of it moving would tear it.
void check_start(Section& section) {
  if (!states_any(section, "support")) return;
  for (const char* key : {"velocity", "angular_velocity"}) {
    if (!section.has(key)) continue;
    section.findings().error(section.where_key(key),
                             fmt::format("'{}' in {}: a body with supports starts at rest", key, section.title()),
                             "leave it out, or the supports");
  }
}

// A body that meets nothing is a scene of its own. drafts: whether all contacts could be read.
void check_company(Section& root, const std::vector<BodyDraft>& bodies, const ContactDrafts& contacts) {
  const std::vector<Section> sections = root.sections("body", {1, 64}), met = root.sections("contact", {0, 64});
  if (bodies.size() > 1 && met.size() > 1)
    root.findings().error(met[1].where(),
                          "scenes of several bodies with more than one contact are understood, but cannot be simulated "
                          "yet: two bodies, and one contact of them");
  for (size_t i = 0; bodies.size() > 1 && i < bodies.size() && i < sections.size(); ++i) {
    const BodyDraft& body = bodies[i];
    if (body.name && contacts.all_bodies_known && !contacts.bodies.contains(*body.name))
      root.findings().error(sections[i].where(),
                            fmt::format("no [[contact]] names body '{}': it is a scene of its own", *body.name));
    if (body.theory.value_or(Theory::solid) != Theory::solid)
      root.findings().error(sections[i].where(), fmt::format("body '{}' of theory '{}' is simulated alone only",
                                                             body.name.value_or(""), to_string(*body.theory)));
  }
}

// Of finite strain all bodies are one system, whose mass damping is one number.
void check_damping_together(Section& root, const std::vector<BodyDraft>& bodies) {
  const auto is_finite = [](const BodyDraft& body) { return body.kinematics == Kinematics::finite; };
  const std::vector<Section> sections = root.sections("body", {1, 64});
  if (std::ranges::none_of(bodies, is_finite)) return;
  for (size_t i = 1; i < bodies.size() && i < sections.size(); ++i) {
    const double alpha = bodies[i].damping.rayleigh.alpha, first = bodies[0].damping.rayleigh.alpha;
    if (alpha != first)
      root.findings().error(
          sections[i].where(),
          fmt::format("body '{}' has alpha = {}, body '{}' {}: where one is of finite kinematics, "
                      "all must have the same",
                      bodies[i].name.value_or(""), number_text(alpha), bodies[0].name.value_or(""), number_text(first)),
          "beta may differ");
  }
}

void check_with_contact(Section& root, const std::vector<BodyDraft>& bodies) {
  if (states_any(root, "load")) refuse_with_contact(root.findings(), root.where_key("load"), "a load");
  for (const BodyDraft& body : bodies) {
    for (const Position& where : body.supports.driven_at) {
      refuse_with_contact(root.findings(), where, "a driven support");
    }
    for (const Position& where : body.dashpots.at) refuse_with_contact(root.findings(), where, "a dashpot");
    if (!body.damping.ratios.empty()) {
      refuse_with_contact(root.findings(), body.damping.ratios_at, "damping of single modes");
    }
  }
}

// Whether the scene is known to stay as it is: all of it could be read, and nothing in it moves.
bool stays(Section& root, const std::vector<BodyDraft>& bodies, const ContactDrafts& contacts,
           const std::optional<Vector3d>& gravity) {
  const auto is_still = [](const BodyDraft& body) {
    return !body.supports.driven && body.twist && body.twist->velocity.isZero(0) &&
           body.twist->angular_velocity.isZero(0);
  };
  return gravity && gravity->isZero(0) && !states_any(root, "load") && !contacts.strikes &&
         std::all_of(bodies.begin(), bodies.end(), is_still);
}

}  // namespace

void check_contact_rules(Section& root, const std::vector<BodyDraft>& bodies, const ContactDrafts& contacts,
                         const std::optional<Vector3d>& gravity) {
  if (!contacts.any) refuse_without_contact(root, "gravity");
  std::size_t i = 0;
  for (Section& section : root.sections("body", {1, 64})) {
    if (!contacts.any) {
      for (const char* key : {"pose", "velocity", "angular_velocity", "starts"}) refuse_without_contact(section, key);
    } else {
      check_start(section);
    }
    // Again, now that it is known what touches.
    if (auto mesh = section.section("resolution")) read_mesh(*mesh, bodies.at(i));
    ++i;
  }
  check_company(root, bodies, contacts);
  check_damping_together(root, bodies);
  if (!contacts.any) return;
  check_with_contact(root, bodies);
  if (stays(root, bodies, contacts, gravity)) {
    root.findings().error(root.where_key("contact"),
                          "nothing would move: there is no gravity, and every body starts at rest",
                          "state 'gravity', or 'velocity' of a body");
  }
}

}  // namespace mb
