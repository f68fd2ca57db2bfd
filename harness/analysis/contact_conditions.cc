// Which contacts of a scene can be foretold: how far a small change at the start shows in each of them.
#include <array>
#include <cmath>

#include "cases/contract/touchdown.h"
#include "harness/analysis/contact_tables.h"
#include "harness/analysis/told.h"
#include "harness/metrics/contact_metrics.h"

namespace mb {

namespace {

constexpr double change = 0.01;  // [-] of the stiffness: more than what steps do, and small enough to be near linear
constexpr size_t most = 4;       // contacts that are shown
constexpr int n_mode_counts = 3;

Finding contacts_table() {
  return table("contact-stiffness", "contacts-in-turn", "Contacts one by one",
               "Touches that follow each other within half of the first one's duration are one contact. Errors against "
               "the truth's same contact, relative, that of the start to the duration of the truth's first; their "
               "bars 5/4 of the distance to those against its coarser mesh, more where that is near, or against a "
               "closed form that of its series; of the values themselves as much of what steps twice as long, or ten "
               "times the tolerance, move. Empty: it has no "
               "such contact.",
               {{"contact", ""},
                {"contender", ""},
                {"modes r", ""},
                {"touches", ""},
                {"start", "s"},
                {"duration", "s"},
                {"peak force", "N"},
                {"impulse", "N s"},
                {"error of start", "-"},
                {"error of duration", "-"},
                {"error of peak force", "-"},
                {"error of impulse", "-"}});
}

Finding conditions_table() {
  return table(
      "contact-stiffness", "contact-conditions", "How small changes grow from contact to contact",
      "Each contact answered again with the layer's stiffness larger by a hundredth. Condition: change over "
      "the value, of the start over the duration of the first contact, by that hundredth. Of the first "
      "contact alone it is about 0.4 at most in size (on a wall F ~ k^(2/5), Hertz); what it has more afterwards the "
      "motion in between has made. Bars: 5/4 of what steps twice as long, or ten times the tolerance, move, or as much "
      "more as truths have of near meshes. Empty: the same contact is not there again.",
      {{"contact", ""},
       {"contender", ""},
       {"modes r", ""},
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

using Contacts = std::vector<FirstContact>;

// [-] of start, duration, peak force and impulse of the k-th of them, relative, of the impulse how far the vectors are
// apart; NaN where one has none or it lasts.
std::array<double, 4> differences(const Contacts& of, const Contacts& against, size_t k) {
  const double nan = std::nan("");
  if (k >= of.size() || k >= against.size()) return {nan, nan, nan, nan};
  const auto lasts = [](const FirstContact& c) { return c.whole.end - c.whole.start; };
  const auto relative = [](double a, double b, double size) { return (a - b) / size; };
  const Touch &a = of[k].whole, &b = against[k].whole;
  return {relative(a.start, b.start, lasts(against.front())),
          relative(lasts(of[k]), lasts(against[k]), lasts(against[k])),
          relative(a.peak_force, b.peak_force, b.peak_force), (a.impulse - b.impulse).norm() / b.impulse.norm()};
}

std::array<double, 4> sizes(std::array<double, 4> of) {
  for (double& one : of) one = std::abs(one);
  return of;
}

// The truth, and its neighbour, whose distance is its bar; of a closed form [-] that of its series.
struct Truths {
  Contacts truth, neighbour;
  double exact_bar = 0;
};

// Of errors e relative to a closed form at least its own bar, times 1 + e.
void bar_errors(Finding& contacts, double exact_bar) {
  for (size_t j = 0; j < contacts.columns.size(); ++j) {
    if (!contacts.columns[j].name.starts_with("error of")) continue;
    for (size_t i = 0; i < contacts.rows.size(); ++i) {
      const double error = std::get<double>(contacts.rows[i][j]);
      contacts.bars[i][j] = std::fmax(contacts.bars[i][j], exact_bar * (1 + error));
    }
  }
}

// Of one contender, as it is and with the stiffer layer.
struct Answers {
  Contacts contacts, stiffer;

  std::array<double, 4> conditions(size_t k) const {
    std::array<double, 4> all = differences(stiffer, contacts, k);
    for (double& one : all) one /= change;
    return all;
  }
};

void add(std::vector<FindingCell>& row, const std::array<double, 4>& values) {
  for (const double value : values) row.push_back(number(value));
}

void add_touch(std::vector<FindingCell>& row, const Contacts& contacts, size_t k) {
  if (k >= contacts.size()) return row.resize(row.size() + 5, not_applicable());
  const Touch& touch = contacts[k].whole;
  row.insert(row.end(), {count(contacts[k].n_touches), touch.start, number(touch.end - touch.start), touch.peak_force,
                         touch.impulse.norm()});
}

// `beside`: the same tables with what is next to each value, at the distance of its bar.
void add_rows(std::vector<Finding>& found, std::vector<Finding>& beside, const ContactContender& of,
              const Answers& answers, const Answers& coarse, const Truths& truths) {
  for (size_t k = 0; k < std::min(answers.contacts.size(), most); ++k) {
    std::vector<FindingCell> row{count(static_cast<Index>(k) + 1),
                                 of.modes < 0 ? "full order, the truth's tolerance" : of.method,
                                 of.modes < 0 ? not_applicable() : count(of.modes)};
    std::vector<FindingCell> conditions = row, near_conditions = row;
    add(conditions, answers.conditions(k)), add(near_conditions, coarse.conditions(k));
    std::vector<FindingCell> near = row;
    add_touch(row, answers.contacts, k), add_touch(near, coarse.contacts, k);
    add(row, sizes(differences(answers.contacts, truths.truth, k)));
    add(near, sizes(differences(answers.contacts, truths.neighbour, k)));
    found[0].rows.push_back(std::move(row)), beside[0].rows.push_back(std::move(near));
    found[1].rows.push_back(std::move(conditions)), beside[1].rows.push_back(std::move(near_conditions));
  }
}

// Full order, which is dear, where there is a second contact that it could tell of.
std::vector<ContactContender> contenders(const ContactVariants& variants, const AnalysisContext& context,
                                         const Contacts& truth) {
  std::vector<ContactContender> all;
  for (const ContactContender& of : variants.contenders()) {
    if (of.modes < 0 && truth.size() < 2) continue;
    const std::vector<int> counts = of.modes < 0 ? std::vector{of.modes} : few(mode_counts(context), n_mode_counts);
    for (const int r : counts) all.push_back({of.method, r, of.time_step});
  }
  return all;
}

}  // namespace

std::vector<Finding> contact_conditions(const ContactVariants& variants, const AnalysisContext& context) {
  std::vector<Finding> found{contacts_table(), conditions_table()};
  Scene as_it_is = *context.scene, stiffer = *context.scene;
  for (const Meeting& meeting : touchdown(as_it_is, as_it_is.bodies.front()).meetings) {
    as_it_is.contacts[meeting.contact].stiffness = meeting.size.stiffness;
    stiffer.contacts[meeting.contact].stiffness = (1 + change) * meeting.size.stiffness;
  }
  Truths truths{contacts_in(context.truth.finer), contacts_in(context.truth.coarser)};
  if (context.truth.exact) {  // a closed form may end with the first contact
    Contacts exact = contacts_in(*context.truth.exact);
    if (exact.size() >= truths.truth.size()) truths = {exact, exact, context.truth.exact_bar};
  }
  std::vector<Finding> beside{contacts_table(), conditions_table()};
  for (const ContactContender& of : contenders(variants, context, truths.truth)) {
    const Answers answers{contacts_in(variants.simulate(as_it_is, of)), contacts_in(variants.simulate(stiffer, of))};
    const Answers coarse{contacts_in(variants.simulate_coarsely(as_it_is, of)),
                         contacts_in(variants.simulate_coarsely(stiffer, of))};
    add_rows(found, beside, of, answers, coarse, truths);
  }
  add_bars(found, beside, PerDistance(context.truth.per_distance.mean));
  if (truths.exact_bar > 0) bar_errors(found[0], truths.exact_bar);
  return found;
}

}  // namespace mb
