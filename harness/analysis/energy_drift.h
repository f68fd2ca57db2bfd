// What steps make of the energy of free vibration without damping, and how what is lost or gained grows,
//
//   drift(n) = mean E over a window that ends at step n / mean E over the first window - 1 ~ (steps between them)^p
//
// p = 1: a scheme that loses or gains as it goes; p = 1/2: rounding that wanders; p about 0: none.
#pragma once

#include "cases/contract/method.h"
#include "harness/analysis/power_law.h"

namespace mb {

inline constexpr Index drift_window = 1000;  // [-] steps over which energy is averaged

struct EnergyDrift {
  Status status;
  double swing;         // [-] largest |E/E(0) - 1| within the first window
  double bar_of_swing;  // [-] rounding, as motion a third as large shows, eps a step at the least
  double drift;         // [-] at the end
  double bar;    // [-] of the drift: grid convergence index (harness/metrics/gci.h) of windows of half as many steps,
                 // and what rounding makes of it, as motion a third as large shows
  PowerLaw law;  // of |drift| over the steps from the first window on
};               // all but the status NaN where that is not ok

// system: M = I, K diagonal; its loads, damping and initial state are not used: every elastic mode is let go with the
// same energy. dt [s]; n_steps at least three windows. Throws std::invalid_argument for fewer, and where nothing is
// elastic.
EnergyDrift energy_drift(const Integrator& integrator, const System& system, double dt, Index n_steps);

}  // namespace mb
