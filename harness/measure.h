// The only clock of the suite. Timed parts run alone, on one thread.
#pragma once

#include <functional>
#include <string>

namespace mb {

struct Timing {
  double median;  // [s]
  double spread;  // [s] half the distance of the quartiles; NaN for a single run
  int repeats;    // counted runs
};

double seconds(const std::function<void()>& work);  // one run

// A warm-up, then at least `repeats` runs and `total` seconds.
Timing measure(const std::function<void()>& work, int repeats = 5, double total = 0.2);

std::string utc_date();  // "2026-11-20T23:59:59Z", for provenance

}  // namespace mb
