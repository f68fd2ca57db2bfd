#include "cases/scene/read_theory.h"

#include <fmt/format.h>

#include <algorithm>

namespace mb {

namespace {

const Words theories{{"euler-bernoulli", "kirchhoff"}, "theory", "theories"};

bool is_of_theory(const BodyDraft& body) { return body.theory.value_or(Theory::solid) != Theory::solid; }

std::string described(const BodyDraft& body) {
  return fmt::format("body '{}' of theory '{}'", body.name.value_or(""), to_string(body.theory.value()));
}

// Long along x, or thin along z: where the theory is one of that.
void check_proportions(Section& section, const BodyDraft& body) {
  if (!body.shape) return;
  const Box* box = std::get_if<Box>(&*body.shape);
  const auto refuse = [&](const char* what) {
    section.findings().error(section.where("shape"),
                             fmt::format("theory '{}' is of a box {}", to_string(*body.theory), what));
  };
  if (!box) return refuse("alone");
  const Vector3d& size = box->size;
  if (*body.theory == Theory::euler_bernoulli && !(size.x() > std::max(size.y(), size.z()))) {
    refuse("that is long along x: a beam");
  } else if (*body.theory == Theory::kirchhoff && !(size.z() < std::min(size.x(), size.y()))) {
    refuse("that is thin along z: a plate");
  }
}

// A contact of law penalty of a body that has no local compliance, and the other way round.
void check_law(const MeetingDraft& meeting, const BodyDraft& body, Findings& findings) {
  const bool hertz = meeting.law == ContactLaw::hertz;
  if (hertz && !is_of_theory(body)) {
    findings.error(meeting.law_where,
                   "law 'hertz' counts the local compliance twice: meshes and modes of a solid carry it",
                   "law 'penalty' does not");
  } else if (!hertz && is_of_theory(body)) {
    findings.error(meeting.law_where,
                   fmt::format("law 'penalty' leaves out the local compliance, and so does {}", described(body)),
                   "state law = \"hertz\"");
  } else if (hertz && !meeting.strikes) {
    findings.error(
        meeting.where,
        fmt::format("law 'hertz' needs an obstacle that strikes: '{}' stands still", meeting.obstacle.value_or("")),
        "one states mass, velocity, youngs_modulus and poissons_ratio");
  } else if (!hertz && meeting.strikes) {
    findings.error(
        meeting.law_where,
        fmt::format("obstacle '{}' strikes: only law 'hertz' knows what moves it", meeting.obstacle.value_or("")),
        "an obstacle without mass and velocity stands still");
  }
}

void check_struck(Section& section, const BodyDraft& body, const ContactDrafts& contacts) {
  if (!is_of_theory(body) || !body.name || !contacts.all_bodies_known || contacts.bodies.contains(*body.name)) return;
  section.findings().error(section.where("theory"), fmt::format("nothing strikes {}", described(body)),
                           "it takes an [[obstacle]] with mass and velocity, and a [[contact]] with law = \"hertz\"");
}

}  // namespace

std::optional<Theory> read_theory(Section& body) {
  if (!body.has("theory")) return Theory::solid;
  const auto word = body.choice("theory", theories);
  if (!word) return std::nullopt;
  return *word == to_string(Theory::kirchhoff) ? Theory::kirchhoff : Theory::euler_bernoulli;
}

void check_theory(Section& section, const BodyDraft& body) {
  if (!is_of_theory(body)) return;
  Findings& findings = section.findings();
  check_proportions(section, body);
  if (body.material && body.material->orthotropy)
    findings.error(section.where("material"),
                   fmt::format("theory '{}' is of isotropic materials", to_string(*body.theory)));
  if (body.material && !body.material->inclusions.empty())
    findings.error(section.where("material"),
                   fmt::format("theory '{}' is of one material throughout", to_string(*body.theory)));
  if (section.has("support") && !section.is_empty_array("support"))
    findings.error(
        section.where_key("support"),
        fmt::format("theory '{}' states its supports itself: simply supported at {}", to_string(*body.theory),
                    *body.theory == Theory::kirchhoff ? "its four edges" : "both ends"),
        "leave them out");
  for (const char* key : {"pose", "velocity", "angular_velocity"}) {
    if (!section.has(key)) continue;
    findings.error(section.where_key(key),
                   fmt::format("'{}' in {}: a body of theory '{}' lies still at the origin", key, section.title(),
                               to_string(*body.theory)),
                   "leave it out");
  }
}

void check_strikes(Section& root, const std::vector<BodyDraft>& bodies, const ContactDrafts& contacts) {
  Findings& findings = root.findings();
  for (const MeetingDraft& meeting : contacts.meetings) {
    const auto body = std::ranges::find(bodies, meeting.body, &BodyDraft::name);
    if (meeting.body && body != bodies.end() && body->theory && meeting.law && meeting.obstacle)
      check_law(meeting, *body, findings);
  }
  std::size_t i = 0;
  for (Section& section : root.sections("body", {1, 64})) check_struck(section, bodies.at(i++), contacts);
  if (!contacts.strikes) return;
  for (std::size_t k = 1; k < contacts.meetings.size(); ++k)
    findings.error(contacts.meetings[k].where, "another [[contact]] beside that of an obstacle that strikes",
                   "one body and one obstacle, whose distance is among the unknowns");
  if (root.has("gravity"))
    findings.error(root.where_key("gravity"),
                   "'gravity' is understood, but cannot be simulated yet together with an obstacle that strikes");
}

std::vector<Obstacle> placed(std::vector<Obstacle> obstacles, const std::vector<ContactPair>& pairs,
                             const std::vector<BodyDraft>& bodies) {
  for (Obstacle& obstacle : obstacles) {
    const auto* shape = std::get_if<Shape>(&obstacle.surface.shape);
    const Sphere* ball = shape ? std::get_if<Sphere>(shape) : nullptr;
    const auto pair = std::ranges::find(pairs, obstacle.name, &ContactPair::obstacle);
    if (!obstacle.striker || !ball || pair == pairs.end()) continue;
    const auto body = std::ranges::find(bodies, std::optional(pair->body), &BodyDraft::name);
    const Box* box = body != bodies.end() && body->shape ? std::get_if<Box>(&*body->shape) : nullptr;
    if (box) obstacle.surface.pose.position.z() = box->size.z() / 2 + ball->radius;
  }
  return obstacles;
}

}  // namespace mb
