#include "cases/contract/physical_shift.h"

namespace mb {

double physical_shift(const Body& body) {
  const double l = extent(body.shape);
  return -0.01 * body.material.youngs_modulus / (body.material.density * l * l);
}

}  // namespace mb
