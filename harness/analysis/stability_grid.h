// What steps of one length make of a system, of whatever scheme and whatever it predicts:
//
//   unstable     E(t) > 1e4 E(0) in free vibration within so many steps, or under the scene's loads more than 1000
//                times off the closed form, or off by more than the whole where rho^n > 10 of the n steps of that run,
//                or no number, or a run that says so
//   inaccurate   neither, and under the scene's loads more than 5 % off the closed form
//   stable       neither, and within that
//
// beside rho, the largest spectral radius of the one-step amplification over the modes, or of one step of all of them
// where damping couples them (mechanics/system/stepped_modes.h).
// Free vibration: from rest, every elastic mode with the same energy. Exact motion only loses energy. What a stable
// scheme makes of it may swing, at x = omega h: central differences down to 1 - x^2/4 and never up, as
// E_n = cos^2(n theta) + (1 - x^2/4) sin^2(n theta); average acceleration keeps it (Hughes 1987, sect. 9.1); symplectic
// Euler, with damping a = c h, has of (v, omega u)
//
//   A = [1 - a, -x; x (1 - a), 1 - x^2],   A^T Q A = (1 - a) Q,   Q = [x (1 - a), (a - x^2)/2; (a - x^2)/2, x]
//
// so that from rest E_n/E_0 <= x/lambda_min(Q) = 1/(1 - a/2 - sqrt(a^2 + (a/x - x)^2)/2), undamped 1/(1 - x/2), below
// 1e4 but for the last fiftieth of a per cent before the limit (Hairer, Lubich & Wanner 2006, sect. I.1, for a = 0).
// Central differences whose damping lags move (w, omega u) by the same A, w the rate half a step before: with
//
//   v = (1 - a/2) w - x/2 omega u = l^T (w, omega u),   w_0 = x/(2 (1 - a)) omega u_0
//
// E_n/E_0 <= y_0^T Q y_0 lambda_max(Q^-1 (l l^T + e e^T)), y = (w, omega u)/(omega u_0), e = (0, 1); undamped 1.
#pragma once

#include <optional>
#include <string>

#include "cases/contract/method.h"
#include "mechanics/system/stepped_modes.h"

namespace mb {

enum class StepClass { stable, inaccurate, unstable };
const char* to_string(StepClass of);  // "stable", "inaccurate", "unstable"

constexpr double energy_bound = 1e4;      // [-] of E(t)/E(0)
constexpr double near_limit = 2e-4;       // [-] of a step, by the above
constexpr double inaccurate_from = 0.05;  // [-] of the error in the M norm over the scene's sample times
// As of runs, harness/study/instability.h:
constexpr double runaway_from = 1000;  // [-] of that error
constexpr double lost_from = 1;        // [-] likewise, where free vibration grows over the run
constexpr double grown_from = 10;      // [-] rho^n

// A system in modal coordinates, as project() makes it: M = I, K diagonal, the first R.cols() coordinates rigid.
struct MappedSystem {
  System system;
  SteppedModes modes;
  VectorXd times;  // [s] of the scene's samples
  MatrixXd exact;  // elastic coordinates in closed form at these, n_elastic x n_t
};
// duration [s] bounds the times.
MappedSystem mapped_system(System system, const VectorXd& times, double duration, double load_tolerance);

struct StepCell {
  double dt;
  double radius;  // [-] rho; NaN where no scheme is known to step as the integrator does
  Index n_modes;
  long n_steps;   // of free vibration
  double energy;  // [-] largest E(t)/E(0); infinity: no number
  double bound;   // [-] of it, by the above; NaN past the limit, where damping couples modes, where it lags and
                  // steps of a mode do not swing, and of other schemes
  double error;   // [-] NaN where unstable
  StepClass found;
  // Whether unstable, else stable; none: unknown, or growth that is too slow to be seen in n_steps and in the run.
  std::optional<StepClass> predicted;
  bool at_limit;  // unstable although not so by rho, which passes 1 within `near_limit` of the step
};
StepCell step_cell(const MappedSystem& mapped, const Integrator& integrator, double dt, long n_steps);

// [-] What rounding makes of the energy, if that is finite: eps of it a step, or twice what it is otherwise where the
// motion is a third as large, which is the same but for rounding; whichever is larger.
double bar_of_energy(const MappedSystem& mapped, const Integrator& integrator, const StepCell& cell);

// "as predicted", "not as predicted", "at the limit", "too slow to be seen", "no prediction"
std::string verdict(const StepCell& cell);

// dt [s] where rho passes 1; 0: at any step; infinity: nowhere; NaN: unknown. As exact as
// stable_omega_h (mechanics/system/stability.h), where damping couples modes to 1e-9 of it.
double predicted_limit(const MappedSystem& mapped, const std::string& integrator);

}  // namespace mb
