// The closed form `timoshenko-impact`: a rigid ball on the middle of a simply supported Euler-Bernoulli beam, by
// Volterra's equation (timoshenko_impact.h), at the scene's sample times. With q_n the modes of the march, k_n = n
// pi/L,
//
//   w(x, t) = F(t) g(x) + sum_n (q_n - F 2/(rho A L omega_n^2)) cos k_n x,    g = xi (3 L^2 - 4 xi^2)/(48 E I),
//
// xi = L/2 - |x|: the load's static response takes what the modes left out follow it with (mode acceleration), so that
// strains converge, too. Displacement (-z w', 0, w), strain -z w'' with -nu of it across, as the model's
// (reference/theory/theory_model.h), w along z: that above is downwards.
#pragma once

#include "cases/exact/exact.h"

namespace mb {

ExactSolution struck_beam();

}  // namespace mb
