#include "reports/times.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace mb {
namespace {

std::string provenance_of(const Record& record, const std::string& key) {
  const auto entry = record.provenance.find(key);
  return entry == record.provenance.end() ? "" : entry->second;
}

}  // namespace

bool is_time(const Record& record) { return record.truth.empty() && record.metric.ends_with("-time"); }

double busy_share(const Record& time) {
  const std::string text = provenance_of(time, "busy");
  double share = 1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), share);
  const bool known = error == std::errc() && end == text.data() + text.size() && share > 0;
  return known && share < busy_enough ? share : 1;
}

bool is_perturbed(const Record& time) { return busy_share(time) < busy_enough; }

TimeRange range_of(const Record& time) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!time.error_bar) return {nan, nan};
  return {busy_share(time) * std::max(0.0, time.value - *time.error_bar), time.value + *time.error_bar};
}

Machine machine_of(const Record& record) {
  return {provenance_of(record, "processor"), provenance_of(record, "blas"), provenance_of(record, "threads")};
}

std::map<CaseProfile, Machine> machines_compared(const std::vector<Record>& records) {
  std::map<CaseProfile, std::map<Machine, long>> n_times;
  for (const Record& record : records) {
    if (is_time(record)) ++n_times[{record.case_name, record.profile}][machine_of(record)];
  }
  std::map<CaseProfile, Machine> machines;
  for (const auto& [of, counts] : n_times) {
    const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
    machines[of] = std::max_element(counts.begin(), counts.end(), fewer)->first;
  }
  return machines;
}

long count_times_left_out(const std::vector<Record>& records) {
  const std::map<CaseProfile, Machine> machines = machines_compared(records);
  return std::count_if(records.begin(), records.end(), [&](const Record& record) {
    return is_time(record) && machine_of(record) != machines.at({record.case_name, record.profile});
  });
}

}  // namespace mb
