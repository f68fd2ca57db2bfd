#include "cases/contract/physical_shift.h"

namespace mb {

double physical_shift(const Body& body) {
  const Vector3d size = extents(body.shape);
  const double l = size.maxCoeff(), h = size.minCoeff();
  return -0.01 * body.material.youngs_modulus / (body.material.density * l * l) * (h / l);
}

}  // namespace mb
