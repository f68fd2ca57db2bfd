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
    if (is_of_truth(record)) continue;
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

bool precedes(const Contender& a, const Contender& b) { return order({}, {}, a) < order({}, {}, b); }

bool is_reduced(const Contender& contender) { return contender.method != "full-order"; }

bool is_of_truth(const Record& record) { return record.metric.starts_with("truth-"); }

bool is_mark(const Record& record) { return !record.truth.empty() && !is_of_truth(record); }

bool is_usable(const Record& record) { return record.status == "ok" && std::isfinite(record.value); }

bool is_undefined(const Record& record) { return record.status.starts_with("undefined"); }

double counted_error(const Record& record) { return std::max(std::abs(record.value), record.error_bar.value_or(0)); }

std::string reason(const Record& record) {
  static const std::string prefix = "failed: ";
  if (record.status == "ok") return "not_finite";
  return record.status.starts_with(prefix) ? record.status.substr(prefix.size()) : record.status;
}

std::string describe(const Contender& contender) {
  return describe_family(contender) + ", " + describe_setting(contender);
}

std::string describe_family(const Contender& contender) {
  return is_reduced(contender) ? contender.method : to_string(contender.resolution) + ", " + contender.integrator;
}

std::string describe_setting(const Contender& contender) {
  const Settings& settings = contender.settings;
  if (is_reduced(contender)) return "r = " + std::to_string(settings.modes);
  if (settings.time_step > 0) return "step " + format_setting(settings.time_step) + " s";
  return "rtol " + format_setting(settings.relative_tolerance);
}

std::string describe_series(const Contender& contender) {
  if (is_reduced(contender)) return contender.method;
  return "full order Q" + std::to_string(contender.resolution.degree) + ", " + contender.integrator;
}

}  // namespace mb
