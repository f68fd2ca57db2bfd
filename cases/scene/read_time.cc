#include "cases/scene/read_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/scene/number_text.h"
#include "cases/scene/read_profile.h"

namespace mb {

namespace {

const Range duration_range{0, 1e5, "s", true};
const Range rate_range{0, 1e9, "1/s", true}, from_range{0, 1e5, "s"};

// Records where a rate asks for more samples than memory holds, or for none but the first.
void check_samples(Section& section, const std::string& key, double rate, const Times& times, double from) {
  const double longest = times.longest().value(), shortest = times.shortest().value();
  const double n = rate * std::max(0.0, longest - from);
  if (n > most_samples) {
    section.error(key, fmt::format("'{}' = {} makes {} samples in {} s: at most {:.0f}", key, number_text(rate),
                                   number_beside(n, most_samples), number_text(longest - from), most_samples));
  }
  if (rate * shortest < 1) {
    section.error(key, fmt::format("'{}' = {} makes no sample after the first in {} s", key, number_text(rate),
                                   number_text(shortest)));
  }
}

bool is_less(const std::pair<const std::string, std::optional<double>>& a,
             const std::pair<const std::string, std::optional<double>>& b) {
  return a.second < b.second;  // nothing is less than any
}

}  // namespace

std::optional<double> Times::shortest() const {
  return std::min_element(duration.begin(), duration.end(), is_less)->second;
}

std::optional<double> Times::longest() const {
  return shortest() ? std::max_element(duration.begin(), duration.end(), is_less)->second : std::nullopt;
}

std::vector<double> Times::looked_at() const {
  std::vector<double> all;
  if (!longest()) return all;
  for (const auto& [rate, from] : {std::pair(frame_rate, 0.0), std::pair(samples_per_second, samples_from)}) {
    const double first = std::ceil(from * rate), end = *longest();
    for (double i = first; i / rate <= end && i - first <= most_samples; ++i) all.push_back(i / rate);
  }
  return all;
}

Times read_times(Section& root) {
  Times times;
  auto section = root.section("time");
  const auto duration = section ? section->number("duration", duration_range) : std::nullopt;
  for (const std::string& name : profile_names()) {
    auto profile = read_profile(root, name);
    const bool own = profile && profile->has("duration");
    times.duration[name] = own ? profile->number("duration", duration_range) : duration;
  }
  if (!section) return times;
  const auto frame_rate = section->number("frame_rate", rate_range);
  const auto samples = section->number("samples_per_second", rate_range);
  const double from = section->number("samples_from", from_range, 0);
  section->finish();
  times.frame_rate = frame_rate.value_or(1);
  times.samples_per_second = samples.value_or(1);
  times.samples_per_second_at = section->where("samples_per_second");
  times.samples_from = from;
  if (times.samples_from > 0 && !root.has("contact"))
    section->error("samples_from", "'samples_from' is of scenes with contact: without, the motion begins at once");
  if (!times.shortest()) return times;
  if (frame_rate) check_samples(*section, "frame_rate", *frame_rate, times, 0);
  if (samples) check_samples(*section, "samples_per_second", *samples, times, from);
  if (times.samples_from > 0 && (*times.shortest() - times.samples_from) * times.samples_per_second < 1)
    section->error("samples_from",
                   fmt::format("'samples_from' = {} leaves no two samples before the end", number_text(from)));
  return times;
}

}  // namespace mb
