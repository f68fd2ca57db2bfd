#include "harness/measure.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace mb {

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Timing measure(const std::function<void()>& work, int repeats, double total) {
  work();
  std::vector<double> runs;
  double sum = 0;
  while (static_cast<int>(runs.size()) < repeats || (sum < total && runs.size() < 10'000)) {
    runs.push_back(seconds(work));
    sum += runs.back();
  }
  std::sort(runs.begin(), runs.end());
  const auto quantile = [&](double q) {
    return runs[static_cast<size_t>(q * static_cast<double>(runs.size() - 1) + 0.5)];
  };
  return {quantile(0.5), 0.5 * (quantile(0.75) - quantile(0.25)), static_cast<int>(runs.size())};
}

std::string utc_date() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace mb
