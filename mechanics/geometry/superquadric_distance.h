#pragma once
#include "mechanics/geometry/signed_distance.h"
namespace mb {
Distance superquadric_distance(const Superquadric& body, const Vector3d& x);
double superquadric_distance_value(const Superquadric& body, const Vector3d& x);
}  // namespace mb
