#include <stdexcept>

#include "mechanics/algebra/noise.h"
#include "modal/bases/eigenmodes.h"

namespace mb {

double physical_shift(const Body& body) {
  const double l = extent(body.shape);
  return -0.01 * body.material.youngs_modulus / (body.material.density * l * l);
}

double default_shift(const System& system) {
  const double trace_ratio = system.K.diagonal().sum() / system.M.diagonal().sum();  // of the order of lambda_max
  if (!(trace_ratio > 0)) throw std::invalid_argument("default_shift: M or K has no positive trace");
  const ShiftedFactor first = shifted_factor(system, -1e-8 * trace_ratio);
  // Inverse iteration, rigid modes projected out each time: the Rayleigh quotient falls towards lambda_1 from above.
  // From noise ten steps leave less than a factor of 2 (the first tens of eigenvalues differ by about that much).
  VectorXd v = without_rigid_part(system, uniform_noise(system.K.rows(), 3));
  for (int step = 0; step < 10; ++step) {
    v = without_rigid_part(system, first.factor.solve(VectorXd(system.M * v)));
    v /= std::sqrt(v.dot(system.M * v));
  }
  const double lambda_1 = v.dot(system.K * v);
  if (!(lambda_1 > 0)) throw std::invalid_argument("default_shift: the system has no elastic mode");
  return -0.01 * lambda_1;
}

}  // namespace mb
