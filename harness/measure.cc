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

namespace {

double processor_seconds() {  // of this thread
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Timing one_series(const std::function<void()>& work, int repeats, double total) {
  std::vector<double> runs;
  double sum = 0;
  const double before = processor_seconds();
  while (static_cast<int>(runs.size()) < repeats || (sum < total && runs.size() < 10'000)) {
    runs.push_back(seconds(work));
    sum += runs.back();
  }
  const double busy = (processor_seconds() - before) / sum;
  std::sort(runs.begin(), runs.end());
  const auto quantile = [&](double q) {
    return runs[static_cast<size_t>(q * static_cast<double>(runs.size() - 1) + 0.5)];
  };
  return {quantile(0.5), 0.5 * (quantile(0.75) - quantile(0.25)), static_cast<int>(runs.size()), busy};
}

}  // namespace

Timing once(const std::function<void()>& work) {
  const double before = processor_seconds();
  const double time = seconds(work);
  return {time, std::numeric_limits<double>::quiet_NaN(), 1, (processor_seconds() - before) / time};
}

Timing measure(const std::function<void()>& work, int repeats, double total) {
  constexpr double undisturbed = 0.95;
  Timing best = one_series(work, repeats, total);
  for (int attempt = 1; attempt < 3 && best.busy < undisturbed; ++attempt)
    if (const Timing next = one_series(work, repeats, total); next.busy > best.busy) best = next;
  return best;
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
