// Which contacts of a scene can be foretold: how far a small change at the start shows in each of them.
#include <cmath>

#include "cases/contract/touchdown.h"
#include "harness/analysis/contact_tables.h"
#include "harness/metrics/contact_metrics.h"

namespace mb {

namespace {

constexpr double change = 0.01;  // [-] of the stiffness: more than what steps do, and small enough to be near linear
constexpr size_t most = 4;       // contacts that are shown

Finding condition_table() {
  return table(
      "contact-stiffness", "contact-conditions", "How small changes grow from contact to contact",
      "Contacts one by one, touches that follow each other within half of the first one's duration as one; each "
      "answered twice, the second time with the layer's stiffness larger by a hundredth. Condition: change relative to "
      "the value, of the start to the duration of the first contact, over that hundredth; the layer's own share is "
      "about 0.4 of peak force and duration (Hertz: F ~ k^(2/5)). Where it is tens, an error of a thousandth of what "
      "came before is one of percents there: such a contact can be compared, but is no measure of a method. Empty: "
      "one of the two has no such contact.",
      {{"contact", ""},
       {"contender", ""},
       {"modes r", ""},
       {"touches", ""},
       {"start", "s"},
       {"duration", "s"},
       {"peak force", "N"},
       {"impulse", "N s"},
       {"condition of start", "-"},
       {"condition of duration", "-"},
       {"condition of peak force", "-"},
       {"condition of impulse", "-"}});
}

// Of an answer's first body, in order; those of chattering joined, as the metrics of contact join them.
std::vector<FirstContact> contacts_in(const Trajectory& answer) {
  std::vector<FirstContact> all;
  if (answer.status != Status::ok) return all;
  std::vector<Touch> rest = answer.bodies.front().contact.touches;
  while (const auto contact = first_contact(rest, rest)) {
    all.push_back(*contact);
    rest.erase(rest.begin(), rest.begin() + contact->n_touches);
  }
  return all;
}

// [-] NaN, shown as empty, of a contact that does not end.
double condition(double before, double after, double size) { return std::abs(after - before) / size / change; }

std::vector<FindingCell> measures(const Touch& touch) {
  return {touch.start, number(touch.end - touch.start), touch.peak_force, touch.impulse.norm()};
}

std::vector<FindingCell> conditions(const Touch& a, const Touch& b, double first_duration) {
  const double lasts = a.end - a.start;
  return {number(condition(a.start, b.start, first_duration)), number(condition(lasts, b.end - b.start, lasts)),
          number(condition(a.peak_force, b.peak_force, a.peak_force)),
          number((b.impulse - a.impulse).norm() / a.impulse.norm() / change)};
}

}  // namespace

Finding contact_conditions(const ContactVariants& variants, const AnalysisContext& context) {
  Finding found = condition_table();
  const Scene& scene = *context.scene;
  const Touchdown down = touchdown(scene, scene.bodies.front());
  Scene as_it_is = scene, stiffer = scene;
  for (const Meeting& meeting : down.meetings) {
    as_it_is.contacts[meeting.contact].stiffness = meeting.size.stiffness;
    stiffer.contacts[meeting.contact].stiffness = (1 + change) * meeting.size.stiffness;
  }
  for (const ContactContender& of : variants.contenders()) {
    const auto before = contacts_in(variants.simulate(as_it_is, of)),
               after = contacts_in(variants.simulate(stiffer, of));
    for (size_t k = 0; k < std::min(before.size(), most); ++k) {
      const Touch& touch = before[k].whole;
      std::vector<FindingCell> row{count(static_cast<int>(k) + 1),
                                   of.modes < 0 ? "full order, the truth's tolerance" : of.method,
                                   of.modes < 0 ? not_applicable() : count(of.modes), count(before[k].n_touches)};
      const auto values = measures(touch);
      const Touch& first = before.front().whole;
      const auto rest = k < after.size() ? conditions(touch, after[k].whole, first.end - first.start)
                                         : std::vector<FindingCell>(4, not_applicable());
      row.insert(row.end(), values.begin(), values.end());
      row.insert(row.end(), rest.begin(), rest.end());
      found.rows.push_back(std::move(row));
    }
  }
  return found;
}

}  // namespace mb
