// What is made of speed-ups: the headline of a report and the simulated time after which preparation has paid.
#pragma once

#include <optional>

#include "reports/content.h"

namespace mb {

std::vector<SpeedUp> of_norm(const std::vector<SpeedUp>& all, const std::string& metric);

// Those that no other reduced run of the same case, profile, truth and norm beats in both error and time. A reduced run
// whose time has no spread counts like the others.
std::vector<SpeedUp> on_front(const std::vector<SpeedUp>& all);

// Of every case and profile the cheapest reduced run whose counted error against `truth` is at most `target` [-].
std::vector<SpeedUp> cheapest_within(const std::vector<SpeedUp>& all, const std::string& truth, double target);

// [-] >= 1: counted error of the reduced run over its rival's, infinite where the latter is 0. Contenders are steps and
// meshes of a sweep, so that the rival is always somewhat too exact. Needs a rival.
double rival_margin(const SpeedUp& one);

// [-] simulated seconds per computing second: 1 is real time.
double real_time_factor(const Record& time, double simulated_seconds);

// Whether the spreads of both times leave open which is the faster; true where one is a single run's without spread and
// the times differ by less than a factor 1.2.
bool is_within_noise(const SpeedUp& one);

// Median over those that have a rival; none where no run has one.
std::optional<double> median_ratio(const std::vector<SpeedUp>& all);

// Simulated seconds T from which  offline + rate T <= rival_offline + rival_rate T;  none where that never happens.
// offline [s], rate [s of computing per simulated second].
std::optional<double> break_even(double offline, double rate, double rival_offline, double rival_rate);

}  // namespace mb
