#include "reports/runs.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "cases/contract/status.h"
#include "reports/number.h"
#include "reports/times.h"
#include "reports/words.h"

namespace mb {
namespace {

template <typename Text>
using Place =
    std::tuple<Text, Text, bool, Text, Text, int, int, std::vector<int>, double, double, double, RotationCoupling>;
using OwnPlace = Place<std::string>;

// Of all bodies.
std::vector<int> counts(const Resolution& mesh) {
  std::vector<int> all = mesh.cells;
  for (const Resolution& other : mesh.others) {
    all.push_back(other.degree);
    for (const int n : counts(other)) all.push_back(n);
  }
  return all;
}

Place<const std::string&> order(const std::string& case_name, const std::string& profile, const Contender& c) {
  return {case_name,
          profile,
          !is_reduced(c),
          c.method,
          c.integrator,
          c.settings.modes,
          c.resolution.degree,
          counts(c.resolution),
          -c.settings.time_step,
          -c.settings.relative_tolerance,
          c.settings.load_tolerance,
          c.settings.rotation};
}

const std::string none;

std::optional<Record> Run::*part_of(const std::string& metric) {
  static const std::map<std::string, std::optional<Record> Run::*> parts = {{"online-time", &Run::online},
                                                                            {"offline-time", &Run::offline},
                                                                            {"stepping-time", &Run::stepping},
                                                                            {"assembly-time", &Run::assembly}};
  const auto entry = parts.find(metric);
  return entry == parts.end() ? nullptr : entry->second;
}

}  // namespace

std::vector<Run> group_runs(const std::vector<Record>& records) {
  const std::map<CaseProfile, Machine> machines = machines_compared(records);
  std::map<OwnPlace, Run> found;
  for (const Record& record : records) {
    if (is_of_truth(record)) continue;
    Run& run = found[OwnPlace(order(record.case_name, record.profile, record.contender))];
    run.case_name = record.case_name;
    run.profile = record.profile;
    run.contender = record.contender;
    run.modes_used = std::max(run.modes_used, record.modes_used);
    run.n_unknowns = std::max(run.n_unknowns, record.n_unknowns);
    if (is_time(record)) {
      const bool compared = machine_of(record) == machines.at({record.case_name, record.profile});
      if (const auto part = part_of(record.metric); part && compared) run.*part = record;
    } else if (is_mark(record)) {
      run.measures.insert_or_assign(Measure{record.metric, record.subject, record.truth}, record);
    }
  }
  std::vector<Run> runs;
  for (auto& [key, run] : found) runs.push_back(std::move(run));
  return runs;
}

const Run* find_run(const std::vector<Run>& grouped, const Record& record) {
  const auto wanted = order(record.case_name, record.profile, record.contender);
  const auto of = [](const Run& run) { return order(run.case_name, run.profile, run.contender); };
  const auto found = std::partition_point(grouped.begin(), grouped.end(), [&](const Run& r) { return of(r) < wanted; });
  return found != grouped.end() && of(*found) == wanted ? &*found : nullptr;
}

bool same_contender(const Contender& a, const Contender& b) { return order(none, none, a) == order(none, none, b); }

bool precedes(const Contender& a, const Contender& b) { return order(none, none, a) < order(none, none, b); }

bool is_reduced(const Contender& contender) { return contender.method != "full-order" && contender.method != "full"; }

bool takes_modes(const Contender& contender) {
  return is_reduced(contender) && contender.method != "linear" && contender.method != "quadratic";
}

bool takes_tolerance(const Contender& contender) {
  return contender.integrator != "exact" && !(contender.settings.time_step > 0);
}

bool steps_in_contact(const Contender& contender) {
  return contender.integrator == "exact" && contender.settings.time_step > 0;
}

double accuracy(const Contender& contender) {
  if (contender.settings.time_step > 0) return contender.settings.time_step;
  return takes_tolerance(contender) ? contender.settings.relative_tolerance : 0;
}

bool is_of_truth(const Record& record) { return record.metric.starts_with("truth-"); }

bool is_mark(const Record& record) { return !record.truth.empty() && !is_of_truth(record); }

bool is_usable(const Record& record) { return record.status == "ok" && std::isfinite(record.value); }

bool is_unstable(const Record& record) { return is_unstable(record.status); }

std::string best_truth(const Run& run, const std::string& metric) {
  const bool has_exact = std::ranges::any_of(
      run.measures, [&](const auto& entry) { return entry.first.metric == metric && entry.first.truth == "exact"; });
  return has_exact ? "exact" : "finer";
}

bool is_against_best(const Run& run, const Measure& measure) {
  return measure.truth == best_truth(run, measure.metric);
}

bool is_undefined(const Record& record) { return is_undefined(record.status); }

double counted_error(const Record& record) { return std::max(std::abs(record.value), record.error_bar.value_or(0)); }

double largest_error(const Record& record) { return std::abs(record.value) + record.error_bar.value_or(0); }

double smallest_error(const Record& record) {
  return std::max(0.0, std::abs(record.value) - record.error_bar.value_or(0));
}

std::string reason(const Record& record) {
  static const std::string prefix = "failed: ";
  if (record.status == "ok") return "not_finite";
  return record.status.starts_with(prefix) ? record.status.substr(prefix.size()) : record.status;
}

std::string describe_mesh(const Resolution& mesh, Theory theory) {
  if (theory == Theory::solid) return to_string(mesh);
  std::vector<std::string> counts;
  for (const int n : mesh.cells) counts.push_back(std::to_string(n));
  return joined(counts, "x") + (mesh.cells == std::vector{1} ? " half wave" : " half waves");
}

std::string describe(const Contender& contender, Theory theory) {
  return joined({describe_family(contender, theory), describe_setting(contender)}, ", ");
}

std::string describe_family(const Contender& contender, Theory theory) {
  const std::string mesh = describe_mesh(contender.resolution, theory);
  if (contender.method == "full-order") return mesh + ", " + describe_integrator(contender);
  if (!is_reduced(contender)) return contender.method + " " + mesh + ", " + describe_integrator(contender);
  return joined({describe_method(contender), contender.integrator == "exact" ? "" : contender.integrator}, ", ");
}

std::string describe_method(const Contender& contender) {
  const RotationCoupling rotation = contender.settings.rotation;
  return contender.method +
         (rotation == RotationCoupling::rigid ? "" : std::string(", rotation ") + to_string(rotation));
}

std::string describe_integrator(const Contender& contender) {
  if (steps_in_contact(contender)) return "closed form, steps in contact";
  return contender.integrator == "exact" ? "closed form" : contender.integrator;
}

std::string describe_size(const Contender& contender, Theory theory) {
  if (takes_modes(contender)) return "r = " + std::to_string(contender.settings.modes);
  return is_reduced(contender) ? "" : describe_mesh(contender.resolution, theory);
}

std::string describe_accuracy(const Contender& contender) {
  const Settings& settings = contender.settings;
  if (settings.time_step > 0) {
    return "step " + format_setting(settings.time_step) + " s" + (steps_in_contact(contender) ? " in contact" : "");
  }
  return takes_tolerance(contender) ? "rtol " + format_setting(settings.relative_tolerance) : "";
}

std::string describe_setting(const Contender& contender) {
  return joined({is_reduced(contender) ? describe_size(contender) : "", describe_accuracy(contender)}, ", ");
}

std::string describe_series(const Contender& contender, Theory theory) {
  if (is_reduced(contender)) return describe_family(contender);
  if (contender.method != "full-order") return "full basis, " + describe_integrator(contender);
  const std::string mesh =
      theory == Theory::solid ? "Q" + std::to_string(contender.resolution.degree) : "in half waves";
  return "full order " + mesh + ", " + describe_integrator(contender);
}

}  // namespace mb
