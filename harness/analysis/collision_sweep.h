// What the contest of collision detection is held on: a body's surface points against a partner of the body's size, the
// one slightly inside the other, and the powers of cost against sizes.
#pragma once

#include <vector>

#include "harness/analysis/power_law.h"
#include "modal/polygons/polygon_contact.h"

namespace mb {

Vector3d half_extents(const Shape& shape);  // [m] of its bounding box

// Of a body's size: the sphere of its greatest extent, and the superquadric with its bounding box and e_1 = e_2 = 1/2.
Sphere sphere_of_size(const Shape& body);
Superquadric superquadric_of_size(const Shape& body);
Superquadric as_superquadric(const Sphere& sphere);  // e_1 = e_2 = 1

// m points [m] all over the body's surface, in the partner's frame: middles of polygons, as evenly chosen as any m
// allows. The body, turned into general position, stands over the partner's top and overlaps it by `overlap` [m] > 0
// where its deepest point is. m in 1..200'000, else std::invalid_argument.
class OverlappingPoints {
 public:
  OverlappingPoints(const Shape& body, const Shape& partner, double overlap);
  Matrix3Xd points(Index m) const;

 private:
  Matrix3Xd all_;
};

// From which size on one cost is below another for good: where the line between the last size at which it is not and
// the next crosses, in logarithms. The first size where it is below at all, NaN where not at the last. x ascending,
// costs > 0, all of one length, else std::invalid_argument.
double crossover(const VectorXd& x, const VectorXd& cost, const VectorXd& other);

}  // namespace mb
