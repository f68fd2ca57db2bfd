// A closed triangle mesh inscribed in the exact surface: every vertex lies on it, the enclosed volume
//
//   V = 1/6 sum over triangles of a . (b x c)
//
// tends to the shape's with the square of the triangles' size.
#pragma once

#include "mechanics/geometry/shape.h"

namespace mb {

struct TriangleMesh {
  Matrix3Xd vertices;          // [m] 3 x n_v, each once
  Eigen::Matrix3Xi triangles;  // 3 x n_t, of indices of vertices in 0..n_v - 1, counter-clockwise from outside
  VectorXd vertex_area;        // [m^2] n_v, a third of the adjacent triangles' area
};

inline constexpr int max_triangles = 10'000'000;

// Each edge of each of surface_patches(shape) in n >= 1 pieces of equal parameter, each quadrilateral cut along its
// shorter diagonal into the triangles 2k and 2k + 1. Every edge belongs to two triangles which run through it in
// opposite directions, and n_v - n_edges + n_t = 2 (Euler). Throws std::invalid_argument for n out of range (more than
// max_triangles), and for shapes so flat (about 1e-11 of their extent) that vertices cannot be told apart.
TriangleMesh triangulate(const Shape& shape, int n);

}  // namespace mb
