// Quadrature on the exact surface, fine near given points (the foci) and coarse far from them:
//
//   integral over the surface of f  ~  sum_i w_i f(x_i)
//
// Every patch of the surface is cut into cells. A cell is halved, across whichever of its two directions is too long,
// while
//
//   length > min(coarsest, max(finest, grading d))
//
// length: of the longest of three chains of two chords, on the cell's two edges and its middle line; d: distance of the
// ball that covers the cell from the nearest focus, never above the cell's own. In a cell n x n Gauss points carry the
// exact area element: exact on rectangles and on a cylinder's side, else of order 2n in the cells' size where the
// patch is smooth. Superquadrics whose exponents lie between 1 and 2 bend without limit on edges of their patches:
// order 2/e (n = 2, e = 1.5, cells of 1/30 of the extent: 2e-4 of the area, and of the volume int x . n dA / 3 4e-5).
#pragma once

#include <limits>
#include <vector>

#include "mechanics/geometry/shape.h"

namespace mb {

struct Grading {
  double finest;            /* [m] > 0, at least 1e-10 of the shape's extent */
  double coarsest;          /* [m] >= finest; infinity: what the patches are long */
  double grading;           /* [-] >= 0, length by distance; 0 is finest everywhere */
  int points_per_cell_edge; /* n in 1..16 */
};

struct GradedRule {
  Matrix3Xd points;   // [m] 3 x m, on the surface
  VectorXd weights;   // [m^2] m, > 0
  Matrix3Xd normals;  // [-] 3 x m, outward
  // [m] m: each point of the surface belongs to the sample of its cell that is nearest by the patch's parameters, and
  // lies no farther than this from it.
  VectorXd radius;
};

inline constexpr int max_graded_cells = 1 << 18;

// foci [m] in the shape's frame, on the surface or not; none: coarsest everywhere. within [m] >= 0: cells whose d is
// larger are left out, so that all of the surface within that distance of a focus is there (perhaps nothing).
// Throws std::invalid_argument for numbers out of these ranges or not finite, for `within` without a focus, and where
// more than max_graded_cells cells were needed.
GradedRule graded_rule(const Shape& shape, const std::vector<Vector3d>& foci, const Grading& grading,
                       double within = std::numeric_limits<double>::infinity());

}  // namespace mb
