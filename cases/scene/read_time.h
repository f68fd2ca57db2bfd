// [time], and `duration` of [profile.NAME]: how long, how often looked at.
#pragma once

#include <map>

#include "cases/scene/section.h"

namespace mb {

struct Times {
  std::map<std::string, std::optional<double>> duration;  // [s] of quick, standard, full; nothing where wrong
  double frame_rate = 1, samples_per_second = 1;          // [1/s]
  Position samples_per_second_at = {};
  double samples_from = 0;  // [s]
  // [s] of all profiles; nothing where one of them is wrong: then nothing is held to it.
  std::optional<double> shortest() const;
  std::optional<double> longest() const;
  std::vector<double> looked_at() const;  // [s] frames and samples of the longest profile, the first 1e5 of each
};

inline constexpr double most_samples = 1e5;  // times at which trajectories are compared: what memory holds

Times read_times(Section& root);

}  // namespace mb
