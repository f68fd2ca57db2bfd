#include "reports/runs.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "reports/number.h"

namespace mb {
namespace {

auto order(const std::string& case_name, const std::string& profile, const Contender& c) {
  return std::tuple(case_name, profile, !is_reduced(c), c.method, c.integrator, c.settings.modes, c.resolution.degree,
                    c.resolution.cells, -c.settings.time_step, -c.settings.relative_tolerance,
                    c.settings.load_tolerance);
}

}  // namespace

std::vector<Run> group_runs(const std::vector<Record>& records) {
  std::map<decltype(order({}, {}, Contender{})), Run> found;
  for (const Record& record : records) {
    Run& run = found[order(record.case_name, record.profile, record.contender)];
    run.case_name = record.case_name;
    run.profile = record.profile;
    run.contender = record.contender;
    run.modes_used = std::max(run.modes_used, record.modes_used);
    run.n_unknowns = std::max(run.n_unknowns, record.n_unknowns);
    if (record.metric == "online-time") {
      run.online = record;
    } else if (record.metric == "offline-time") {
      run.offline = record;
    } else if (is_mark(record)) {
      run.measures.insert_or_assign(Measure{record.metric, record.subject, record.truth}, record);
    }
  }
  std::vector<Run> runs;
  for (auto& [key, run] : found) runs.push_back(std::move(run));
  return runs;
}

bool same_contender(const Contender& a, const Contender& b) { return order({}, {}, a) == order({}, {}, b); }

bool is_reduced(const Contender& contender) { return contender.method != "full-order"; }

bool is_mark(const Record& record) { return !record.truth.empty(); }

bool is_usable(const Record& record) { return record.status == "ok" && std::isfinite(record.value); }

double counted_error(const Record& record) { return std::max(std::abs(record.value), record.error_bar.value_or(0)); }

std::string describe(const Contender& contender) {
  if (is_reduced(contender)) return contender.method + ", r = " + std::to_string(contender.settings.modes);
  std::string text = to_string(contender.resolution) + ", " + contender.integrator;
  if (contender.settings.time_step > 0) return text + ", step " + format_setting(contender.settings.time_step) + " s";
  return text + ", rtol " + format_setting(contender.settings.relative_tolerance);
}

std::string describe_series(const Contender& contender) {
  if (is_reduced(contender)) return contender.method;
  return "full order Q" + std::to_string(contender.resolution.degree) + ", " + contender.integrator;
}

}  // namespace mb
