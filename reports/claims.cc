#include "reports/claims.h"

#include <algorithm>
#include <cmath>

#include "reports/findings.h"
#include "reports/number.h"
#include "reports/speedup.h"
#include "reports/verdict.h"

namespace mb {
namespace {

// One measurement of a claim: where, what, and what it says.
struct Instance {
  std::string where;  // "cylinder-shear"
  std::string label;  // "explicit-euler", "24 1/s", ""
  double value;       // NaN where there is none
  Ruling ruling;
};

Ruling ruling_of(const std::string& verdict) {
  if (verdict == "holds") return Ruling::holds;
  if (verdict.starts_with("holds")) return Ruling::holds_within_limits;
  return verdict.starts_with("does not hold") ? Ruling::does_not_hold : Ruling::not_measured;
}

std::string list(const std::vector<std::string>& names) {
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += (i ? ", " : "") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

std::string range(std::vector<double> values) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  if (values.empty()) return "n/a";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string a = format_number(*low), b = format_number(*high);
  return a == b ? a : a + " to " + b;
}

std::string place(const Instance& one) { return one.label.empty() ? one.where : one.where + " (" + one.label + ")"; }

// "holds in a, b; not in c"
std::string limits(const std::vector<Instance>& instances) {
  std::vector<std::string> inside, partly, outside;
  for (const Instance& one : instances) {
    if (one.ruling == Ruling::holds) inside.push_back(place(one));
    if (one.ruling == Ruling::holds_within_limits) partly.push_back(place(one));
    if (one.ruling == Ruling::does_not_hold) outside.push_back(place(one));
  }
  std::string text;
  for (const auto& [names, words] : {std::pair(&inside, "holds in "), std::pair(&partly, "within limits in "),
                                     std::pair(&outside, "does not hold in ")}) {
    if (!names->empty()) text += (text.empty() ? "" : "; ") + std::string(words) + list(*names);
  }
  return text;
}

// "explicit-euler: 1.99 to 2.01; symplectic-euler: 1.00", in the order of the tables
std::string by_label(const std::vector<Instance>& instances) {
  std::vector<std::pair<std::string, std::vector<double>>> groups;
  for (const Instance& one : instances) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == one.label; });
    if (group == groups.end()) group = groups.insert(groups.end(), {one.label, {}});
    group->second.push_back(one.value);
  }
  std::string text;
  for (const auto& [label, values] : groups) {
    text += (text.empty() ? "" : "; ") + (label.empty() ? "" : label + ": ") + range(values);
  }
  return text;
}

// label: of the instances that decide; the others stand beside them. "": all decide.
void conclude(Claim& claim, const std::vector<Instance>& instances, const std::string& label = "") {
  std::vector<Ruling> rulings;
  for (const Instance& one : instances) {
    if (label.empty() || one.label == label) rulings.push_back(one.ruling);
  }
  claim.ruling = together(rulings);
  if (claim.ruling == Ruling::not_measured) return;
  claim.measured += by_label(instances);
  claim.limits = limits(instances);
}

std::string label_of(const Finding& finding, std::size_t row, const std::string& column) {
  const std::string text = text_at(finding, row, column);
  if (!text.empty()) return text;
  const auto j = column_of(finding, column);
  const double value = number_at(finding, row, column);
  if (!j || std::isnan(value)) return "";
  return format_setting(value) + " " + finding.columns[*j].unit;
}

// Rows of every table of that name which name the claim and carry a verdict.
std::vector<Instance> rows_of(const Evaluation& evaluation, const std::string& claim, const std::string& table,
                              const std::string& label, const std::string& value) {
  std::vector<Instance> all;
  for (const Finding& finding : evaluation.input.findings) {
    if (finding.name != table) continue;
    for (std::size_t i = 0; i < finding.rows.size(); ++i) {
      const std::string named = text_at(finding, i, "claim");
      if (!named.empty() && named != claim) continue;
      all.push_back({finding.case_name, label_of(finding, i, label), number_at(finding, i, value),
                     ruling_of(text_at(finding, i, "verdict"))});
    }
  }
  return all;
}

constexpr double two_orders = 100;  // [-]

void rule_on_speed_up(Claim& claim, const Evaluation& evaluation) {
  std::vector<Instance> instances;
  std::vector<std::string> none;
  const std::vector<SpeedUp> pairs = at_target(evaluation, headline_metric);
  for (const SpeedUp& one : pairs) {
    if (one.rival.empty()) {
      none.push_back(one.error.case_name);
      continue;
    }
    instances.push_back(
        {one.error.case_name, "", one.ratio, one.ratio >= two_orders ? Ruling::holds : Ruling::does_not_hold});
  }
  if (const auto median = median_ratio(pairs))
    claim.measured = "median speed-up " + format_number(*median) + ", range ";
  conclude(claim, instances);
  if (!none.empty())
    claim.limits += (claim.limits.empty() ? "" : "; ") + ("no rival reaches the error in " + list(none));
}

// [-] displacement error by which a shape is still the right one to the eye. Relative to the motion: relative to the
// body, whatever hardly moves would be right.
constexpr double visible = 0.1;

// Of the case's run of that method in closed form; nullptr where none.
const Record* error_of(const Run& run, const std::string& method) {
  if (run.contender.method != method || run.contender.integrator != "exact") return nullptr;
  for (const auto& [measure, record] : run.measures) {
    if (measure.metric == headline_metric && measure.truth == headline_truth && is_usable(record)) return &record;
  }
  return nullptr;
}

void rule_on_polynomials(Claim& claim, const Evaluation& evaluation) {
  std::vector<Instance> quadratic, linear;
  for (const Run& run : evaluation.runs) {
    for (auto [method, instances] : {std::pair("quadratic", &quadratic), std::pair("linear", &linear)}) {
      const Record* record = error_of(run, method);
      if (!record) continue;
      const double value = counted_error(*record);
      instances->push_back({run.case_name, "", value, value <= visible ? Ruling::holds : Ruling::does_not_hold});
    }
  }
  if (!quadratic.empty()) claim.measured = "displacement error with linear and quadratic modes: ";
  conclude(claim, quadratic);
  if (!quadratic.empty() && !linear.empty()) claim.measured += "; with linear modes alone: " + by_label(linear);
}

constexpr const char* statements[][2] = {
    {"C1", "up to two orders of magnitude less computing time, with reasonable accuracy"},
    {"C2", "dropping high modes removes temporal aliasing and the need for time averaging"},
    {"C3", "many inverse problems have a closed form"},
    {"C4", "rigid, linear and quadratic modes suffice, but not for bodies of disparate dimensions"},
    {"C5", "low modes stay valid as the body deforms, high modes do not"},
    {"C6", "the largest stable explicit step is inversely proportional to the highest frequency kept"},
    {"C7", "for fixed excitation energy a mode's displacement falls with the square of its frequency"},
    {"C8", "the residual of the full equations detects truncation; modes chosen from it repair it"},
    {"C9", "modes of a moment-matched box or of a single 20-node element look right"},
    {"C10", "low modes are well described by polynomials of low degree"},
    {"C11", "collision costs O(m) against O(n m)"},
    {"C12", "analytic contact regions give more accurate forces than vertex contact"},
    {"C13", "inverse problems shrink from thousands of unknowns to a few dozen"},
    {"C14", "a ball on a two-by-four ran at about one CPU second a simulated second on a machine of one MIPS"},
    {"C15", "the modal transform is a preconditioner with better conditioning"},
    {"C16", "modal superposition can drive plastic and viscous material"}};

void rule_on(Claim& claim, const Evaluation& evaluation) {
  if (claim.id == "C1") {
    claim.evidence = "speed-up";
    claim.criterion =
        "cheapest reduced run within 1 % displacement error against finer, its cheapest full-order rival "
        "at least 100 times as dear";
    rule_on_speed_up(claim, evaluation);
  } else if (claim.id == "C2") {
    claim.evidence = "aliasing";
    claim.criterion = "verdicts of the aliasing tables, a frame rate each; number: aliasing of modes cut at F/2";
    conclude(claim, rows_of(evaluation, claim.id, "aliasing-claim", "frame rate", "aliasing cut modal"));
  } else if (claim.id == "C4") {
    claim.evidence = "contenders";
    claim.criterion = "displacement error of method quadratic (24 functions) against finer at most 10 %";
    rule_on_polynomials(claim, evaluation);
  } else if (claim.id == "C6") {
    claim.evidence = "step-limits";
    claim.criterion = "exponent of the measured limit over omega, a scheme each; claimed -1";
    conclude(claim, rows_of(evaluation, claim.id, "step-limit-exponents", "scheme", "exponent"));
  } else if (claim.id == "C7") {
    claim.evidence = "mode-amplitudes";
    claim.criterion = "exponent of displacement over frequency for fixed energy; claimed 2, theory 1";
    conclude(claim, rows_of(evaluation, claim.id, "mode-amplitude-exponents", "held fixed", "exponent"), "energy");
  }
}

}  // namespace

const char* to_string(Ruling ruling) {
  switch (ruling) {
    case Ruling::holds:
      return "holds";
    case Ruling::holds_within_limits:
      return "holds within stated limits";
    case Ruling::does_not_hold:
      return "does not hold";
    case Ruling::not_measured:
      return "not measured here";
  }
  return "";
}

Ruling together(const std::vector<Ruling>& rulings) {
  bool all = true, any = false, measured = false;
  for (const Ruling one : rulings) {
    if (one == Ruling::not_measured) continue;
    measured = true;
    all = all && one == Ruling::holds;
    any = any || one != Ruling::does_not_hold;
  }
  if (!measured) return Ruling::not_measured;
  return all ? Ruling::holds : any ? Ruling::holds_within_limits : Ruling::does_not_hold;
}

std::vector<Claim> claims(const Evaluation& evaluation) {
  std::vector<Claim> all;
  for (const auto& [id, statement] : statements) {
    Claim& claim = all.emplace_back();
    claim.id = id;
    claim.statement = statement;
    rule_on(claim, evaluation);
  }
  return all;
}

Sheet claims_table(const Evaluation& evaluation) {
  Sheet table{
      .name = "claims",
      .title = "The paper's claims",
      .note =
          "Pentland and Williams, Good Vibrations, SIGGRAPH 1989. Verdicts follow from the records and tables of "
          "this report and decide no exit code.",
      .columns = {{"id", ""},
                  {"claim", ""},
                  {"verdict", ""},
                  {"measured", ""},
                  {"limits", ""},
                  {"judged by", ""},
                  {"evidence", ""}},
      .rows = {},
      .n_keys = 0};
  for (const Claim& claim : claims(evaluation)) {
    const bool measured = claim.ruling != Ruling::not_measured;
    table.rows.push_back({text_cell(claim.id), text_cell(claim.statement), text_cell(to_string(claim.ruling)),
                          text_cell(measured ? claim.measured : ""), text_cell(claim.limits),
                          text_cell(measured ? claim.criterion : ""), text_cell(measured ? claim.evidence : "")});
  }
  return table;
}

}  // namespace mb
