// Who knows what of a rigid body that is pressed onto the layer of a plane (modal/polygons/plane_contact.h), and how
// far off that is from the exact cap (pressed_cap.h):
//
//   vertices, areas       vertices of a triangulation, each with a third of the adjacent areas
//   vertices, equal       the same vertices, each with the mean of these areas: one stiffness for all
//   quadrature, uniform   as many middles of cells on the exact surface, with exact area elements
//   quadrature, region    at most as many points, all in the region of contact, which is known beforehand
//   curvatures            the closed form; no samples
//
// Bodies: spheres and superquadrics.
#pragma once

#include <string>
#include <vector>

#include "harness/analysis/pressed_cap.h"

namespace mb {

inline constexpr const char* by_areas = "vertices, areas";
inline constexpr const char* by_equal = "vertices, equal";
inline constexpr const char* by_uniform = "quadrature, uniform";
inline constexpr const char* by_region = "quadrature, region";
inline constexpr const char* by_curvatures = "curvatures";

// |found/exact - 1| [-]. hertz: of the resultant of Hertz's pressure on the same region, whose approach is 2 delta;
// spheres alone, else NaN. impulse: of that delivered until the exact body rests; peak, duration: of the impact.
struct ContactErrors {
  double force, area, depth, hertz, impulse, peak, duration;
};
inline constexpr int n_contact_errors = 7;
const std::vector<std::string>& contact_error_names();  // "force", ..., in this order
VectorXd as_vector(const ContactErrors& errors);

// One orientation and depth, exactly.
struct PressedBody {
  Shape shape;
  Vector3d down;  // [-] of unit length, the plane's direction in the body's frame
  PressedCap cap;
  double speed, rest;  // of the impact that reaches this depth: [m^2], [1/m] (layer_impact.h)
};
PressedBody pressed_body(const Shape& shape, const Vector3d& down, double depth);

struct SurfacePoints {
  Matrix3Xd points;  // [m] in the body's frame
  VectorXd weights;  // [m^2]
};
// About 6 k^2 (spheres) or 24 k^2 (superquadrics); k in 1..200.
SurfacePoints vertices_by_areas(const Shape& shape, int k);
SurfacePoints vertices_by_equal(const Shape& shape, int k);
SurfacePoints uniform_quadrature(const Shape& shape, int k);
// At most n >= 24 points within reach of the deepest one; as many as the halving of cells allows.
SurfacePoints region_quadrature(const PressedBody& body, Index n);

ContactErrors errors_of_samples(const PressedBody& body, const SurfacePoints& samples);
ContactErrors errors_of_curvatures(const PressedBody& body);

// Unit vectors [-] 3 x n, n >= 1, evenly spread: Fibonacci's lattice (Swinbank & Purser 2006, Q. J. R. Meteorol. Soc.
// 132). A turn about the plane's normal changes no height: directions of the plane are all orientations.
Matrix3Xd directions(int n);

}  // namespace mb
