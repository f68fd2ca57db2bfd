// f full order, r reduced:
//
//   at equal error:    ratio = min { t_f : e_f <= e_r } / t_r,                 e = max(|error|, bar)
//   at a target:       ratio = min { t_f : E_f <= E } / min { t_r : E_r <= E },   E_i = |error| + bar
#include "reports/speedup.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "reports/number.h"
#include "reports/runs.h"
#include "reports/sweep.h"
#include "reports/times.h"
#include "reports/words.h"

namespace mb {
namespace {

struct Candidate {
  const Run* run;
  const Record* error;
};

bool cheaper(const Candidate& a, const Candidate& b) {
  if (a.run->online->value != b.run->online->value) return a.run->online->value < b.run->online->value;
  return counted_error(*a.error) < counted_error(*b.error);
}

bool is_timed(const Run& run) { return run.online && is_usable(*run.online) && run.online->value > 0; }

// nullptr where none is reached.
template <typename Reached>
const Candidate* cheapest_of(const std::vector<Candidate>& candidates, Reached is_reached) {
  const Candidate* best = nullptr;
  for (const Candidate& one : candidates) {
    if (is_reached(*one.error) && (!best || cheaper(one, *best))) best = &one;
  }
  return best;
}

const Candidate* rival_of(const Candidate& reduced, const std::vector<Candidate>& candidates) {
  return cheapest_of(candidates,
                     [&](const Record& error) { return counted_error(error) <= counted_error(*reduced.error); });
}

// The rival is the cheapest that reaches the error: whatever is cheaper misses it.
const Candidate* near_miss_of(const Candidate& rival, const std::vector<Candidate>& candidates) {
  const Candidate* best = nullptr;
  for (const Candidate& one : candidates) {
    if (one.run->online->value >= rival.run->online->value) continue;
    const double e = counted_error(*one.error), least = best ? counted_error(*best->error) : e;
    if (!best || e < least || (e == least && cheaper(one, *best))) best = &one;
  }
  return best;
}

// Of those below the target's rival the dearest: none of them is sure to be within the target.
const Candidate* dearest_below(const Candidate& rival, const std::vector<Candidate>& candidates) {
  const Candidate* best = nullptr;
  for (const Candidate& one : candidates) {
    if (one.run->online->value >= rival.run->online->value) continue;
    if (!best || cheaper(*best, one)) best = &one;
  }
  return best;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

double quotient(double above, double below) { return below > 0 ? above / below : infinity; }

// Rival and near miss may be nullptr.
SpeedUp against(const Candidate& reduced, const Candidate* rival, const Candidate* miss, const Sweeps& sweeps) {
  SpeedUp result{.error = *reduced.error, .time = *reduced.run->online, .rival = {}, .near_miss = {}};
  if (!rival) return result;
  result.rival = {*rival->error, *rival->run->online};
  result.ratio = rival->run->online->value / result.time.value;
  result.edge = edge_of(sweeps, *rival->run);
  const Range range = ratio_range(result.time, result.rival[1]);
  result.ratio_low = range.low;
  result.ratio_high = range.high;
  if (miss) {
    result.near_miss = {*miss->error, *miss->run->online};
    result.miss_ratio = miss->run->online->value / result.time.value;
  }
  return result;
}

using Comparable = std::tuple<std::string, std::string, Measure>;  // case, profile, measure: what may be compared
struct Sides {
  std::vector<Candidate> reduced, full_order;
};

std::map<Comparable, Sides> sides_of(const std::vector<Run>& runs, const std::string& metric) {
  std::map<Comparable, Sides> all;
  for (const Run& run : runs) {
    if (!is_timed(run)) continue;
    for (const auto& [measure, record] : run.measures) {
      if (measure.metric != metric || !is_usable(record)) continue;
      if (measure.truth == "same_modes") continue;  // of steps alone, which no full order has
      Sides& sides = all[{run.case_name, run.profile, measure}];
      (is_reduced(run.contender) ? sides.reduced : sides.full_order).push_back({&run, &record});
    }
  }
  return all;
}

}  // namespace

std::vector<SpeedUp> speed_ups(const std::vector<Record>& records, const std::string& metric) {
  const std::vector<Run> runs = group_runs(records);
  const Sweeps sweeps = full_order_sweeps(runs);
  std::vector<SpeedUp> results;
  for (const auto& [key, sides] : sides_of(runs, metric)) {
    for (const Candidate& reduced : sides.reduced) {
      const Candidate* rival = rival_of(reduced, sides.full_order);
      const Candidate* miss = rival ? near_miss_of(*rival, sides.full_order) : nullptr;
      results.push_back(against(reduced, rival, miss, sweeps));
    }
  }
  return results;
}

std::vector<SpeedUp> speed_ups_at(double target, const std::vector<Run>& runs, const std::string& metric) {
  const Sweeps sweeps = full_order_sweeps(runs);
  const auto is_within = [&](const Record& error) { return largest_error(error) <= target; };
  std::map<std::pair<std::string, std::string>, SpeedUp> best;  // by case and profile
  for (const auto& [key, sides] : sides_of(runs, metric)) {
    const auto& [case_name, profile, measure] = key;
    const Candidate* reduced = cheapest_of(sides.reduced, is_within);
    if (!reduced || !is_against_best(*reduced->run, measure)) continue;
    const Candidate* rival = cheapest_of(sides.full_order, is_within);
    const Candidate* miss = rival ? dearest_below(*rival, sides.full_order) : nullptr;
    const SpeedUp one = against(*reduced, rival, miss, sweeps);
    const auto [entry, inserted] = best.try_emplace({case_name, profile}, one);
    if (!inserted && one.time.value < entry->second.time.value) entry->second = one;
  }
  std::vector<SpeedUp> results;
  for (const auto& [key, value] : best) results.push_back(value);
  return results;
}

std::vector<SpeedUp> of_norm(const std::vector<SpeedUp>& all, const std::string& metric) {
  std::vector<SpeedUp> results;
  std::copy_if(all.begin(), all.end(), std::back_inserter(results),
               [&](const SpeedUp& one) { return one.error.metric == metric; });
  return results;
}

std::vector<SpeedUp> on_front(const std::vector<SpeedUp>& all) {
  const auto group = [](const SpeedUp& one) {
    return std::tie(one.error.case_name, one.error.profile, one.error.metric, one.error.truth, one.error.subject);
  };
  std::vector<const SpeedUp*> order;
  for (const SpeedUp& one : all) order.push_back(&one);
  std::stable_sort(order.begin(), order.end(), [&](const SpeedUp* a, const SpeedUp* b) {
    return std::tuple(group(*a), a->time.value, counted_error(a->error)) <
           std::tuple(group(*b), b->time.value, counted_error(b->error));
  });
  std::vector<SpeedUp> results;
  for (const SpeedUp* one : order) {  // by rising time: what is no more exact than the last one kept is beaten
    const bool first = results.empty() || group(results.back()) != group(*one);
    if (first || counted_error(one->error) < counted_error(results.back().error)) results.push_back(*one);
  }
  return results;
}

double rival_margin(const SpeedUp& one) {
  const double own = counted_error(one.error), other = counted_error(one.rival.at(0));
  return own == other ? 1 : quotient(own, other);  // 1 also where both are 0
}

Range margin_range(const SpeedUp& one) {
  const Record& rival = one.rival.at(0);
  const double most = largest_error(rival);
  return {most > 0 ? smallest_error(one.error) / most : rival_margin(one),
          quotient(largest_error(one.error), smallest_error(rival))};
}

// The ends of a single run's range are NaN, and so are quotients of them.
Range ratio_range(const Record& time, const Record& slower) {
  const TimeRange own = range_of(time), other = range_of(slower);
  const double low = other.low / own.high;
  return {low, std::isnan(low) ? low : quotient(other.high, own.low)};
}

double real_time_factor(const Record& time, double simulated_seconds) { return simulated_seconds / time.value; }

Range real_time_range(const Record& time, double simulated_seconds) {
  const TimeRange range = range_of(time);
  const double low = simulated_seconds / range.high;
  return {low, std::isnan(low) ? low : quotient(simulated_seconds, range.low)};
}

bool is_within_noise(const SpeedUp& one) {
  constexpr double single_run = 1.2;  // what one run may be off by: another run of it, a busy machine
  if (one.rival.empty()) return false;
  if (std::isnan(one.ratio_low)) {
    return one.ratio * busy_share(one.rival[1]) < single_run && one.ratio > busy_share(one.time) / single_run;
  }
  return one.ratio_low <= 1 && one.ratio_high >= 1;
}

bool has_perturbed_time(const SpeedUp& one) {
  const auto perturbed = [](const std::vector<Record>& side) { return !side.empty() && is_perturbed(side[1]); };
  return is_perturbed(one.time) || perturbed(one.rival) || perturbed(one.near_miss);
}

bool stands_at_edge(const SpeedUp& one) { return !one.edge.empty(); }

std::string cases_where(const std::vector<SpeedUp>& all, bool (*is_so)(const SpeedUp&)) {
  std::vector<std::string> names;
  for (const SpeedUp& one : all) {
    if (is_so(one)) names.push_back(one.error.case_name);
  }
  return listed(names);
}

double least_ratio(const SpeedUp& one) {
  const bool missed = !one.near_miss.empty();
  const double least = busy_share(missed ? one.near_miss[1] : one.rival.at(1)) * (missed ? one.miss_ratio : one.ratio);
  return std::isnan(one.ratio_low) ? least : std::min(least, one.ratio_low);
}

std::vector<std::string> limits_of(const SpeedUp& one) {
  std::vector<std::string> limits;
  const auto add_perturbed = [&](const char* side, const Record& time) {
    if (is_perturbed(time)) limits.push_back(side + (" perturbed (busy " + format_number(busy_share(time), 2) + ")"));
  };
  add_perturbed("run", one.time);
  if (!one.rival.empty()) add_perturbed("rival", one.rival[1]);
  if (!one.near_miss.empty()) add_perturbed("near miss", one.near_miss[1]);
  if (!one.edge.empty()) limits.push_back("rival at the edge of its sweep: " + one.edge);
  return limits;
}

std::optional<double> median_ratio(const std::vector<SpeedUp>& all) {
  std::vector<double> ratios;
  for (const SpeedUp& one : all) {
    if (!one.rival.empty()) ratios.push_back(one.ratio);
  }
  if (ratios.empty()) return std::nullopt;
  std::sort(ratios.begin(), ratios.end());
  const std::size_t middle = ratios.size() / 2;
  return ratios.size() % 2 ? ratios[middle] : 0.5 * (ratios[middle - 1] + ratios[middle]);
}

std::optional<double> break_even(double offline, double rate, double rival_offline, double rival_rate) {
  if (offline <= rival_offline && rate <= rival_rate) return 0.0;
  if (rate >= rival_rate) return std::nullopt;
  return std::max(0.0, (offline - rival_offline) / (rival_rate - rate));
}

Range break_even_range(const Costs& own, const Costs& rival, double simulated_seconds) {
  const TimeRange offline = range_of(own.offline), rate = range_of(own.online);
  const TimeRange rival_offline = range_of(rival.offline), rival_rate = range_of(rival.online);
  const double any = offline.low + rate.low + rival_offline.low + rival_rate.low;
  if (std::isnan(any)) return {any, any};
  const double T = simulated_seconds;
  return {break_even(offline.low, rate.low / T, rival_offline.high, rival_rate.high / T).value_or(infinity),
          break_even(offline.high, rate.high / T, rival_offline.low, rival_rate.low / T).value_or(infinity)};
}

}  // namespace mb
