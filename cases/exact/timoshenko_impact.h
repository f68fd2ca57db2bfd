// Rigid ball on the middle of a simply supported Euler-Bernoulli beam through Hertz's contact: Volterra's equation
//
//   F(t) = k <w>^(3/2),   w(t) = v t - 1/m int_0^t (t - s) F ds - sum_n 2/(rho A L omega_n) int_0^t F sin omega_n (t -
//   s) ds omega_n = (n pi/L)^2 sqrt(E I / (rho A)),   n = 1, 3, 5, ...,   <w> = max(w, 0)
//
// marched with F linear over each step, for which every convolution is an exact recurrence: w(t_1) = w* - c F(t_1), and
// sqrt(w) solves s^2 + c k s^3 = w*. The only error is the curvature of F, O(h^2), next O(h^(5/2)) as F starts and ends
// like t^(3/2); `beam_impact` extrapolates h and h/2 to the latter. Timoshenko 1913, Z. Math. Phys. 62, 198-209;
// Goldsmith 1960, Impact, sect. 4.4.
#pragma once

#include "mechanics/types.h"

namespace mb {

struct BeamImpact {
  double length;             // L [m] > 0
  double bending_stiffness;  // E I [N m^2] > 0
  double mass_per_length;    // rho A [kg/m] > 0
  double ball_mass;          // m [kg] > 0
  double contact_stiffness;  // k [N/m^1.5] > 0
  double speed;              // v [m/s] > 0, downwards
};

struct BeamMarch {
  double interval;  // [s] > 0 between samples
  Index n_samples;  // >= 1 after t = 0
  Index n_steps;    // >= 1 of an interval
  Index n_modes;    // >= 1, n = 1, 3 ... 2 n_modes - 1
};

struct BeamMotion {
  VectorXd t;              // [s] n_samples + 1, from 0
  VectorXd force;          // F [N] >= 0
  VectorXd ball, midspan;  // [m] downwards
  VectorXd ball_rate;      // [m/s] downwards
  MatrixXd modes;          // q [m] n_modes x samples: w(x) = sum q_n cos(n pi x/L) downwards, x from midspan
  double peak, peak_time;  // [N], [s] of the first contact
  double touch_end;        // [s] end of the first contact; none within the time: its end
  double impulse;          // [N s] of the first contact
  double rebound_speed;    // [m/s] of the ball after it, upwards
  double beam_energy;      // [J] of the modes after it
  Index n_contacts;        // that began
};

// March with steps of interval / n_steps: order 2.
BeamMotion march_beam_impact(const BeamImpact& impact, const BeamMarch& march);
// Extrapolated from the march asked for and one of half its steps, (4 fine - coarse)/3.
BeamMotion beam_impact(const BeamImpact& impact, const BeamMarch& march);
// Both throw std::invalid_argument for what is not finite or out of range.

}  // namespace mb
