// The boundary of a shape as smooth maps x(s, t) of the unit square, outward oriented:
//
//   normal = by_s x by_t / |by_s x by_t|,   dA = |by_s x by_t| ds dt
//
//   box       6 rectangles
//   cylinder  the side in 4 quarters; each end in 5 blocks without a degenerate point: a square of half diagonal 0.6 R,
//             and between each of its edges and a quarter of the rim a block ruled by straight lines. Area elements,
//             by R^2: 0.72 in the square, 0.24 (at its corners) to 0.91 in the others
//   sphere    the faces of the circumscribed cube, projected radially: x = u / g(u), g the gauge, u on the cube at
//   equal
//             angles (Ronchi, Iacono & Paolucci 1996, J. Comput. Phys. 124)
//   superquadric  likewise from the circumscribed box, each face in its 4 quarters, so that what may be sharp (e > 1:
//   the
//             planes through the centre; e < 1: over the box's edges) lies on edges of the 24 patches
//   tapered superquadric  these, through the taper (tapered.h)
//
// Neighbouring patches share whole edges, and there the same parameter (or one less it): grids of them fit.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "mechanics/geometry/shape.h"
#include "mechanics/geometry/tapered.h"

namespace mb {

struct SurfacePoint {
  Vector3d x;           // [m] in the shape's frame
  Vector3d by_s, by_t;  // [m] dx/ds, dx/dt
};

struct ParameterCell {
  double s0 = 0, s1 = 1, t0 = 0, t1 = 1; /* [-] 0 <= s0 < s1 <= 1, likewise t */
};

class SurfacePatch {
 public:
  // x = origin + s a + t b.
  struct Rectangle {
    Vector3d origin, a, b; /* [m] a x b outward */
  };
  // A quarter of the side, centred at k pi/2.
  struct Side {
    Cylinder cylinder;
    int quarter; /* k in 0..3 */
  };
  // One of the five blocks of an end: k in 0..3 touches the rim at the angle k pi/2, 4 is the square.
  struct EndBlock {
    Cylinder cylinder;
    int block;  /* k in 0..4 */
    bool upper; /* z = +length/2, else -length/2 */
  };
  // x = u / g(u),   u = axes (tan a, tan b, 1),   a = pi/4 (2 S - 1), b = pi/4 (2 T - 1), (S, T) across the range.
  struct Radial {
    std::variant<Sphere, Superquadric> body;
    Eigen::Matrix3d axes;       /* [m] columns right-handed: the half axes of the circumscribed box */
    ParameterCell range;        /* the part of the box's face */
    std::optional<Taper> taper; /* of the body: x goes on through it */
  };
  using Kind = std::variant<Rectangle, Side, EndBlock, Radial>;

  explicit SurfacePatch(Kind kind) : kind_(std::move(kind)) {}
  // s, t [-] in [0, 1]; NaN gives NaN. by_s x by_t is never 0. Where a superquadric has an edge or a tip (e = 2) the
  // derivative across is the mean of both sides', as that of the gauge is.
  SurfacePoint at(double s, double t) const;

  // A bound [m] of the distance of x(s, t) from every point of the cell's image; (s, t) in the cell. Reached, but for
  // rounding, on rectangles and sides; elsewhere above the farthest corner's distance by a part of second order in the
  // cell's size where the surface is smooth.
  double covering_radius(const ParameterCell& cell, double s, double t) const;

 private:
  Kind kind_;
};

// Throws std::invalid_argument where a length of the shape is not in [1e-100, 1e100] m, or an exponent not in [0.1, 2].
std::vector<SurfacePatch> surface_patches(const Shape& shape);

}  // namespace mb
