// What is made of speed-ups: the headline of a report and the simulated time after which preparation has paid.
#pragma once

#include <optional>

#include "reports/content.h"

namespace mb {

// Of every case and profile the cheapest reduced run whose counted error against `truth` is at most `target` [-].
std::vector<SpeedUp> cheapest_within(const std::vector<SpeedUp>& all, const std::string& truth, double target);

// [-] >= 1: counted error of the reduced run over its rival's, infinite where the latter is 0. Contenders are steps and
// meshes of a sweep, so that the rival is always somewhat too exact. Needs a rival.
double rival_margin(const SpeedUp& one);

// Median over those that have a rival; none where no run has one.
std::optional<double> median_ratio(const std::vector<SpeedUp>& all);

// Simulated seconds T from which  offline + rate T <= rival_offline + rival_rate T;  none where that never happens.
// offline [s], rate [s of computing per simulated second].
std::optional<double> break_even(double offline, double rate, double rival_offline, double rival_rate);

}  // namespace mb
