// A closed triangle mesh as collision detection has it. The signed distance of a point x from its triangles:
//
//   d = +-|x - c|, > 0 outside,   c: nearest point of all triangles,   sign of (x - c) . n
//
// n is the pseudo-normal of what c lies on: of a face its normal, of an edge the sum of both faces', of a vertex the
// sum weighted by the angles there; with it the sign is right for every closed mesh (Baerentzen & Aanaes 2005, IEEE
// Trans. Vis. Comput. Graph. 11(3)). c by the Voronoi regions of a triangle (Ericson 2005, Real-Time Collision
// Detection, sect. 5.1.5).
#pragma once

#include <array>
#include <vector>

#include "mechanics/geometry/triangulation.h"

namespace mb {

// Of one triangle: what the nearest point lies on, 0 the face, 1..3 the edge from corner i - 1 to the next, 4..6 the
// corner i - 4.
struct NearestOnTriangle {
  double squared_distance;  // [m^2]
  Vector3d point;           // [m]
  int feature;              // 0..6
};

class Polygons {
 public:
  // Throws std::invalid_argument where a vertex is not finite or not there, a triangle has no area, or an edge has not
  // just one triangle on each side.
  explicit Polygons(TriangleMesh mesh);

  const TriangleMesh& mesh() const { return mesh_; }
  Index size() const { return mesh_.triangles.cols(); }  // triangles
  double extent() const { return extent_; }              // [m] largest |coordinate| of a vertex
  long bytes() const;                                    // of vertices, triangles and normals

  // A point of an edge or of a vertex is the same to the bit from all triangles that share it. i in 0..size() - 1.
  NearestOnTriangle nearest(Index i, const Vector3d& x) const;
  // The signed distance of x whose nearest point on all triangles is this one, found on triangle i.
  double signed_distance(Index i, const Vector3d& x, const NearestOnTriangle& nearest) const;

 private:
  struct Normals {
    std::array<Vector3d, 7> of_feature;  // [any unit]
  };
  void add_normals();

  TriangleMesh mesh_;
  double extent_ = 0;
  std::vector<Normals> normals_;  // one a triangle
};

}  // namespace mb
