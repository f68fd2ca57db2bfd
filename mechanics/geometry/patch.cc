#include "mechanics/geometry/patch.h"

namespace mb {

double weight(const Patch& patch, const Vector3d& x) {
  if (!patch.disc) return 1;
  const double s = (x - patch.disc->centre).squaredNorm() / (patch.disc->radius * patch.disc->radius);
  return s < 1 ? (1 - s) * (1 - s) : 0;
}

}  // namespace mb
