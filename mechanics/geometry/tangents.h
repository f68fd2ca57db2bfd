// Two orthonormal vectors across a unit normal, without a branch at the poles:
//
//   t1 = (1 + s n1^2 c, s n1 n2 c, -s n1),   t2 = (n1 n2 c, s + n2^2 c, -n2),   s = sign n3,   c = -1 / (s + n3)
//
// Duff, Burgess, Christensen, Hery, Kensler, Liani & Villemin 2017, Journal of Computer Graphics Techniques 6(1).
#pragma once

#include <cmath>

#include "mechanics/types.h"

namespace mb {

inline Eigen::Matrix<double, 3, 2> tangents(const Vector3d& n) {
  const double s = std::copysign(1.0, n[2]), c = -1 / (s + n[2]), mixed = n[0] * n[1] * c;
  Eigen::Matrix<double, 3, 2> t;
  t << 1 + s * n[0] * n[0] * c, mixed, s * mixed, s + n[1] * n[1] * c, -s * n[0], -n[1];
  return t;
}

}  // namespace mb
