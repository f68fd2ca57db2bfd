// The only clock of the suite. Timed parts run alone, on one thread.
#pragma once

#include <functional>
#include <limits>
#include <string>

namespace mb {

struct Timing {
  double median;  // [s]
  double spread;  // [s] half the distance of the quartiles; NaN for a single run
  int repeats;    // counted runs
  double busy = std::numeric_limits<double>::quiet_NaN();  // [-] processor time of this thread / wall-clock time, all
                                                           // runs: well below 1 where something else had the core
};

double seconds(const std::function<void()>& work);  // one run
Timing once(const std::function<void()>& work);     // one run, without a spread

// At least `repeats` runs and `total` seconds. No warm-up: run the work once before. Taken anew, up to three times,
// where something else had the core (busy < 0.95); the least perturbed one counts.
Timing measure(const std::function<void()>& work, int repeats = 5, double total = 0.02);

std::string utc_date();  // "2026-11-20T23:59:59Z", for provenance

}  // namespace mb
