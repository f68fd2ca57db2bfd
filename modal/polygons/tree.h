// A tree of boxes over the triangles of a mesh: a point visits the nearer child first and leaves out boxes that are
// farther than the nearest triangle it has seen:
//
//   |x - box| > |x - c|  =>  nothing in the box is nearer
//
// Some log n boxes are left near the surface; from afar about sqrt(n), because boxes of slanted triangles reach out of
// the surface by their own size.
//
// The tree is that of CGAL (Alliez, Tayeb & Wormser, 3D Fast Intersection and Distance Computation, CGAL 5.5), halves
// by number along the longest side of the box. What boxes and triangles are tested by is ours, so that the answers are
// those of brute force to the bit.
#pragma once

#include <limits>
#include <memory>

#include "modal/polygons/polygon_contact.h"

namespace mb {

class PolygonTree {
 public:
  // The polygons must outlive the tree: a tree alone knows no vertices.
  explicit PolygonTree(const Polygons& polygons);
  ~PolygonTree();
  PolygonTree(PolygonTree&&) noexcept;
  PolygonTree& operator=(PolygonTree&&) noexcept;

  // As distances_by_brute_force. within [m] >= 0: points farther from all triangles are left early and get infinity,
  // whichever side they are on. Throws std::invalid_argument likewise, and where within is negative or NaN.
  PointDistances distances(const Matrix3Xd& points, double within = std::numeric_limits<double>::infinity()) const;
  long bytes() const;  // of boxes and leaves, without the polygons

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace mb
