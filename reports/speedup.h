// What is made of speed-ups: the headline of a report and the simulated time after which preparation has paid.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/content.h"
#include "reports/runs.h"

namespace mb {

std::vector<SpeedUp> of_norm(const std::vector<SpeedUp>& all, const std::string& metric);

// Those that no other reduced run of the same case, profile, truth and norm beats in both error and time. A reduced run
// whose time has no spread counts like the others.
std::vector<SpeedUp> on_front(const std::vector<SpeedUp>& all);

// Of every case and profile the cheapest reduced run within the target over the cheapest full-order one: both have an
// error against the best truth (runs.h) that is at most `target` [-], error bar included. Their errors differ. The near
// miss is the dearest of the full-order runs that are cheaper than the rival: none of them is sure to be within the
// target.
std::vector<SpeedUp> speed_ups_at(double target, const std::vector<Run>& runs, const std::string& metric);

// [-] >= 1: counted error of the reduced run over its rival's, infinite where the latter is 0. Contenders are steps and
// meshes of a sweep, so that the rival is always somewhat too exact. Needs a rival.
double rival_margin(const SpeedUp& one);

// What the parts of a quotient leave of it: NaN where one is a single run's time, infinite where it has no upper end.
struct Range {
  double low, high;
};

Range ratio_range(const Record& time, const Record& slower);  // [-] of slower / time
Range margin_range(const SpeedUp& one);                       // [-] by both error bars; 0 and up below them

// [-] simulated seconds per computing second: 1 is real time.
double real_time_factor(const Record& time, double simulated_seconds);
Range real_time_range(const Record& time, double simulated_seconds);

// Whether the ranges of both times leave open which is the faster; true where one is a single run's without spread and
// the times differ by less than a factor 1.2, and what perturbed them.
bool is_within_noise(const SpeedUp& one);

bool has_perturbed_time(const SpeedUp& one);  // of the run, its rival or the near miss

bool stands_at_edge(const SpeedUp& one);  // its rival, of the full-order sweep

std::string cases_where(const std::vector<SpeedUp>& all, bool (*is_so)(const SpeedUp&));  // names, "a, b"

// [-] the least that the measurements leave of the ratio: the miss speed-up where there is a near miss, or the low end
// of the range where that is less. Needs a rival.
double least_ratio(const SpeedUp& one);

// What a reader has to know of it: "rival perturbed (busy 0.62)", "rival at the edge of its sweep: coarsest mesh".
std::vector<std::string> limits_of(const SpeedUp& one);

// Median over those that have a rival; none where no run has one.
std::optional<double> median_ratio(const std::vector<SpeedUp>& all);

// Simulated seconds T from which  offline + rate T <= rival_offline + rival_rate T;  none where that never happens.
// offline [s], rate [s of computing per simulated second].
std::optional<double> break_even(double offline, double rate, double rival_offline, double rival_rate);

// Infinite where it may never happen; NaN as the offline times are single runs', unless these have a spread.
struct Costs {
  Record offline, online;  // [s] before and while `simulated` seconds pass
};
Range break_even_range(const Costs& own, const Costs& rival, double simulated_seconds);

}  // namespace mb
