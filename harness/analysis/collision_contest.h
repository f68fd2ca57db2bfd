// The contest itself: every contender on the same points against the same partner, timed and counted.
//
//   polygons, brute force         distances of all points
//   polygons, tree                the same
//   polygons, tree within reach   distances of points within a reach of the surface: what contact asks for
//   analytic, distance            distances of all points
//   analytic, function            the inside-outside function of a superquadric alone, depth of first order
//   analytic, depth inside        distances of points inside: what contact asks for
#pragma once

#include <string>
#include <vector>

#include "harness/analysis/collision_sweep.h"
#include "harness/measure.h"

namespace mb {

struct CollisionSizes {
  std::vector<int> edges;  // ascending, n = m = 48 k^2 for each k
  int fixed;               // k of n = 48 k^2 in the sweep over m
  double most_products;    // n m up to which brute force is tried
  int repeats;             // of each timing
  double total;            // [s] likewise, at least
};
CollisionSizes usual_sizes();

struct CollisionRun {
  std::string contender;
  double n;            // polygons; NaN of analytic contenders
  double m;            // points
  Timing time;         // of one query: all m points
  double tests;        // boxes, triangles and functions, of one query
  double building;     // [s] of the tree, median; NaN where there is none
  double bytes;        // of what a query reads: polygons, tree, or the shape
  double depth_error;  // [m] largest deviation from the exact distance, of points within reach of the surface
};

inline constexpr const char* brute_force = "polygons, brute force";
inline constexpr const char* tree = "polygons, tree";
inline constexpr const char* tree_within_reach = "polygons, tree within reach";
inline constexpr const char* analytic_distance = "analytic, distance";
inline constexpr const char* analytic_function = "analytic, function";
inline constexpr const char* depth_inside = "analytic, depth inside";

// Partner: sphere or superquadric. Shares of the body's greatest half extent.
inline constexpr double overlap_share = 0.04, reach_share = 0.1;

// n = m over sizes.edges; and n fixed, m over all sizes.
struct CollisionContest {
  std::vector<CollisionRun> together, fixed_polygons;
};
CollisionContest collision_contest(const Shape& body, const Shape& partner, const CollisionSizes& sizes);

}  // namespace mb
