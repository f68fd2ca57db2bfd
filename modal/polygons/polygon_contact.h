// m points against one body, as the paper's contest has it (Pentland & Williams 1989, sect. 4.1). For each point the
// signed distance d [m] from the body, negative inside:
//
//   polygons, brute force   every point against each of n triangles                          O(n m)
//   polygons, tree          every point down a tree of boxes (tree.h), O(m log n) near the surface, built before
//   analytic, distance      nearest point of the exact surface (signed_distance.h)           O(m)
//   analytic, function      d ~ (N - 1) / |grad N|, N the gauge of a superquadric: what one value of the inside-outside
//                           function tells, exact in sign; of first order in d (Taubin 1991, IEEE Trans. PAMI 13(11))
//
// Both kinds of polygons agree to the bit; with the exact distance but for the chords' error, of order 1/n.
#pragma once

#include "modal/polygons/polygons.h"

namespace mb {

// Elementary tests stand beside distances: they are the cost that repeats to the last digit.
struct PointDistances {
  VectorXd value;        // [m] m
  long n_boxes = 0;      // boxes that points were tested against
  long n_triangles = 0;  // triangles likewise
  long n_functions = 0;  // evaluations of an analytic function
  long n_tests() const { return n_boxes + n_triangles + n_functions; }
};

// points [m] 3 x m in the body's frame, m >= 0. All throw std::invalid_argument where one is not finite, the analytic
// ones also for an impossible shape.
PointDistances distances_by_brute_force(const Polygons& polygons, const Matrix3Xd& points);
PointDistances distances_by_surface(const Shape& shape, const Matrix3Xd& points);
PointDistances distances_by_function(const Superquadric& body, const Matrix3Xd& points);
// Distances of points inside alone, which is what contact asks for; the others get infinity. Of a superquadric each
// point is tested against the bounding box, what is left against the function, and what is inside gets its distance.
PointDistances depths_inside(const Shape& shape, const Matrix3Xd& points);

void require_finite_points(const Matrix3Xd& points);

}  // namespace mb
