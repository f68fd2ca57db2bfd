#include "mechanics/geometry/superquadric_distance.h"

#include <stdexcept>

namespace mb {

Distance superquadric_distance(const Superquadric&, const Vector3d&) {
  throw std::logic_error("superquadric_distance: not written yet");
}
double superquadric_distance_value(const Superquadric&, const Vector3d&) {
  throw std::logic_error("superquadric_distance: not written yet");
}

}  // namespace mb
