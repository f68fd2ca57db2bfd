#include "harness/study/front.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

#include "reports/views.h"

namespace mb {

namespace {

struct Run {
  double time = -1;
  bool once = false;
  std::map<std::string, double> errors;  // by norm, truth and way to count the bar
};

constexpr std::array<std::string_view, 3> norms{"displacement-error", "strain-error", "surface-deviation"};

std::map<std::string, Run> full_order_runs(const std::vector<Record>& records) {
  std::map<std::string, Run> runs;
  for (const Record& r : records) {
    if (r.contender.method != "full-order" || r.status != "ok") continue;
    if (r.metric == "online-time") {
      runs[r.run].time = r.value;
      runs[r.run].once = !r.error_bar;
    } else if ((r.truth == "finer" || r.truth == "exact") && std::ranges::find(norms, r.metric) != norms.end()) {
      const double bar = r.error_bar.value_or(0);
      runs[r.run].errors[r.metric + " " + r.truth] = std::max(r.value, bar);
      const double most = r.value + bar;
      if (most <= looser_target)
        runs[r.run].errors[r.metric + " " + r.truth + ", target"] = most <= error_target ? error_target : looser_target;
    }
  }
  std::erase_if(runs, [](const auto& entry) { return entry.second.time < 0; });
  return runs;
}

}  // namespace

std::vector<std::string> dear_front(const std::vector<Record>& records) {
  const auto runs = full_order_runs(records);
  std::set<std::string> chosen;
  for (const auto& [name, run] : runs)
    for (const auto& [measure, error] : run.errors) {
      if (!run.once) continue;
      const bool beaten = std::any_of(runs.begin(), runs.end(), [&](const auto& other) {
        const auto rival = other.second.errors.find(measure);
        return rival != other.second.errors.end() && rival->second <= error && 1.33 * other.second.time < run.time;
      });
      if (!beaten) chosen.insert(name);
    }
  return {chosen.begin(), chosen.end()};
}

}  // namespace mb
