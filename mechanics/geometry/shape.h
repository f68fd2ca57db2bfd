// Analytic shapes in their own frame: the centroid at the origin, cylinder along z. Lengths in [m].
//
//   integral over the shape of f  ~  sum_i w_i f(x_i)
//
// The quadratures sample the exact shape, not a mesh: answers on different meshes meet at these points.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "mechanics/types.h"

namespace mb {

struct Box {
  Vector3d size; /* [m] edge lengths along x, y, z, each > 0 */
};
struct Cylinder {
  double radius; /* [m] > 0 */
  double length; /* [m] > 0, along z */
};
struct Sphere {
  double radius; /* [m] > 0 */
};
struct Superquadric {
  Vector3d semi_axes; /* [m] a1, a2, a3, each > 0 */
  double e1, e2;      /* [-] each in [0.1, 2]: of the profiles along z, of the sections across (superquadric.h) */
};
struct TaperedSuperquadric {
  Superquadric straight;
  double taper; /* [-] sections grow by the factor 1 + taper z/a3 along z; at most 2^(e1/2) (1 - e1/2) (tapered.h) */
};
using Shape = std::variant<Box, Cylinder, Sphere, Superquadric, TaperedSuperquadric>;

double volume(const Shape& shape);     // [m^3]
Vector3d extents(const Shape& shape);  // [m] edges of the bounding box along x, y, z
double extent(const Shape& shape);     // [m] the largest of them: the size that deviations are divided by

// Names by which case files refer to parts of the boundary: box x-min x-max y-min y-max z-min z-max;
// cylinder side z-min z-max; sphere and superquadrics surface.
std::vector<std::string> face_names(const Shape& shape);

// Outward normal of a plane face. Throws std::invalid_argument for a curved or unknown face.
Vector3d plane_normal(const Shape& shape, const std::string& face);
bool is_plane(const Shape& shape, const std::string& face);

// Signed distance [m] of x from the surface that carries the face (plane, cylinder, sphere, superquadric), positive
// outside. Throws std::invalid_argument for an unknown face.
double face_distance(const Shape& shape, const std::string& face, const Vector3d& x);
bool contains(const Shape& shape, const Vector3d& x, double tolerance);  // tolerance [m]: x may lie that far outside

struct Quadrature {
  Matrix3Xd points;  // [m] 3 x n
  VectorXd weights;  // [m^3] or [m^2], n, all > 0
};
Quadrature volume_quadrature(const Shape& shape);   // about 300 points, weights sum to the volume (relative 1e-14)
Quadrature surface_quadrature(const Shape& shape);  // about 200 points on the exact surface, weights sum to its area

}  // namespace mb
