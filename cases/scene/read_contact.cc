#include "cases/scene/read_contact.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/names.h"
#include "cases/scene/read_obstacle.h"
#include "mechanics/contact/law.h"

namespace mb {

namespace {

const Range stiffness_range{1, 1e20, "Pa/m"}, hertz_range{1, 1e20, "N/m^1.5"};
const Range damping_range{0, 1e6, "s/m"};
const Range coefficient_range{0, 10, "", true};
const Range slip_range{1e-9, 100, "m/s"};

std::vector<ObstacleDraft> read_obstacles(Section& root) {
  std::vector<ObstacleDraft> drafts;
  Names names("obstacle");
  for (Section& section : root.sections("obstacle", {0, 64})) {
    drafts.push_back(read_obstacle(section));
    names.add(section, drafts.back().name);
  }
  return drafts;
}

// Zero where there is none; nothing where it is wrong.
std::optional<Friction> read_friction(Section& contact) {
  if (!contact.has("friction")) return Friction{0, 0};
  auto table = contact.section("friction");
  if (!table) return std::nullopt;
  const auto coefficient = table->number("coefficient", coefficient_range);
  const auto slip_speed = table->number("slip_speed", slip_range);
  table->finish();
  if (!coefficient || !slip_speed) return std::nullopt;
  return Friction{*coefficient, *slip_speed};
}

std::optional<ContactLaw> read_law(Section& contact) {
  if (!contact.has("law")) return ContactLaw::penalty;
  const auto word = contact.choice("law", {{"penalty", "hertz"}, "law of contact", "laws of contact"});
  if (!word) return std::nullopt;
  if (*word == "penalty") return ContactLaw::penalty;
  if (contact.has("friction"))
    contact.findings().error(contact.where_key("friction"), "law 'hertz' has no friction: it acts along the normal");
  return ContactLaw::hertz;
}

class ContactReader {
 public:
  ContactReader(const std::vector<BodyDraft>& bodies, std::vector<ObstacleDraft> obstacles)
      : bodies_(names_of(bodies)), obstacles_(std::move(obstacles)), partners_(names_of(obstacles_)) {
    if (in_company()) partners_.insert(partners_.end(), bodies_.begin(), bodies_.end());
  }

  void read(Section section) {
    MeetingDraft meeting{
        read_reference(section, "body", bodies_, "body", "bodies"),
        in_company() ? read_reference(section, "obstacle", partners_, "obstacle or body", "obstacles and bodies")
                     : read_reference(section, "obstacle", partners_, "obstacle", "obstacles"),
        read_law(section),
        false,
        section.where(),
        section.where("law")};
    const bool hertz = meeting.law == ContactLaw::hertz;
    const auto stiffness = section.number_or("auto", 0, "stiffness", hertz ? hertz_range : stiffness_range);
    const double damping = section.number("damping", damping_range, 0);
    const auto friction = read_friction(section);
    section.finish();
    note(section, meeting);
    check_partner(section, meeting);
    for (const ObstacleDraft& obstacle : obstacles_)
      if (meeting.obstacle && obstacle.name == meeting.obstacle) meeting.strikes = obstacle.strikes;
    drafts_.meetings.push_back(meeting);
    if (!meeting.body || !meeting.obstacle || !meeting.law || !stiffness || !friction) return;
    drafts_.pairs.push_back({*meeting.body, *meeting.obstacle, *stiffness, damping, friction->coefficient,
                             friction->slip_speed, *meeting.law});
  }

  // An obstacle that nothing meets was forgotten, unless it is the one that a contact misspells.
  ContactDrafts finished(Findings& findings) {
    for (const ObstacleDraft& obstacle : obstacles_) {
      drafts_.strikes = drafts_.strikes || obstacle.strikes;
      if (!obstacle.name) continue;
      if (all_obstacles_known_ && !met_.contains(*obstacle.name)) {
        findings.error(obstacle.where, fmt::format("no [[contact]] names obstacle '{}'", *obstacle.name));
      }
      if (std::ranges::find(bodies_, obstacle.name) != bodies_.end())
        findings.error(obstacle.where, fmt::format("'{}' is the name of a body, too", *obstacle.name));
      if (obstacle.surface) drafts_.obstacles.push_back({*obstacle.name, *obstacle.surface, obstacle.striker});
    }
    return std::move(drafts_);
  }

 private:
  bool is_body(const std::optional<std::string>& name) const {
    return name && std::ranges::find(bodies_, name) != bodies_.end();
  }

  void check_partner(Section& section, const MeetingDraft& meeting) const {
    if (!is_body(meeting.obstacle)) return;
    if (meeting.body == meeting.obstacle)
      section.error("obstacle", fmt::format("body '{}' cannot meet itself", *meeting.body));
    if (meeting.law == ContactLaw::hertz)
      section.error("law", "law 'hertz' is of an obstacle that strikes, not of another body");
    else if (meeting.body && met_.contains(*meeting.body) && pairs_.contains({*meeting.obstacle, *meeting.body}))
      section.error("obstacle", fmt::format("there is another [[contact]] of body '{}' and body '{}'",
                                            *meeting.obstacle, *meeting.body));
  }

  void note(Section& section, const MeetingDraft& meeting) {
    drafts_.all_bodies_known = drafts_.all_bodies_known && meeting.body && (meeting.obstacle || !in_company());
    all_obstacles_known_ = all_obstacles_known_ && meeting.obstacle;
    if (meeting.body) drafts_.bodies.insert(*meeting.body);
    if (is_body(meeting.obstacle)) drafts_.bodies.insert(*meeting.obstacle);
    if (meeting.obstacle) met_.insert(*meeting.obstacle);
    if (!meeting.body || !meeting.obstacle || pairs_.insert({*meeting.body, *meeting.obstacle}).second) return;
    section.findings().error(section.where(), fmt::format("there is another [[contact]] of body '{}' and obstacle '{}'",
                                                          *meeting.body, *meeting.obstacle));
  }

  bool in_company() const { return bodies_.size() > 1; }

  std::vector<std::optional<std::string>> bodies_;
  std::vector<ObstacleDraft> obstacles_;
  std::vector<std::optional<std::string>> partners_;  // whatever a body may meet
  std::set<std::string> met_;
  std::set<std::pair<std::string, std::string>> pairs_;
  bool all_obstacles_known_ = true;
  ContactDrafts drafts_;
};

}  // namespace

ContactDrafts read_contacts(Section& root, const std::vector<BodyDraft>& bodies) {
  ContactReader reader(bodies, read_obstacles(root));
  const std::vector<Section> sections = root.sections("contact", {0, 64});
  for (const Section& section : sections) reader.read(section);
  ContactDrafts drafts = reader.finished(root.findings());
  drafts.any = root.has("contact") && !root.is_empty_array("contact");
  if (drafts.any && sections.empty()) drafts.all_bodies_known = false;  // of another type
  return drafts;
}

std::vector<BodyDraft> with_touches(std::vector<BodyDraft> bodies, const ContactDrafts& contacts) {
  for (BodyDraft& body : bodies) {
    if (!body.name) continue;
    const bool touches = contacts.bodies.contains(*body.name);
    if (touches || contacts.all_bodies_known) body.touches = touches;
  }
  return bodies;
}

}  // namespace mb
