#include "harness/analysis/collision_contest.h"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "modal/polygons/tree.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Superquadric function_of(const Shape& partner) {
  if (const auto* sphere = std::get_if<Sphere>(&partner)) return as_superquadric(*sphere);
  if (const auto* body = std::get_if<Superquadric>(&partner)) return *body;
  throw std::invalid_argument("collision contest: the partner is neither sphere nor superquadric");
}

Index n_of(int k) { return Index{48} * k * k; }

// 48 k^2 triangles of either shape: 6 patches or 24.
TriangleMesh polygons_of(const Shape& partner, int k) {
  return triangulate(partner, std::holds_alternative<Sphere>(partner) ? 2 * k : k);
}

class Contest {
 public:
  Contest(const Shape& body, const Shape& partner, const CollisionSizes& sizes)
      : sizes_(sizes),
        partner_(partner),
        function_(function_of(partner)),
        size_(half_extents(body).maxCoeff()),
        pool_(body, partner, overlap_share * size_) {}

  // Of one mesh, at several numbers of points.
  void run(int k, const std::vector<Index>& counts, std::vector<CollisionRun>& runs) const {
    const Polygons polygons(polygons_of(partner_, k));
    const PolygonTree tree_of(polygons);
    const double n = static_cast<double>(polygons.size()), within = reach_share * size_;
    const double building = timed([&] { PolygonTree again(polygons); }).median;
    const auto mesh_bytes = static_cast<double>(polygons.bytes());
    const double tree_bytes = mesh_bytes + static_cast<double>(tree_of.bytes());
    for (const Index m : counts) {
      const Matrix3Xd x = pool_.points(m);
      const VectorXd exact = distances_by_surface(partner_, x).value;
      const auto add = [&](const char* name, double polygons_n, double built, double bytes, const auto& query) {
        const PointDistances found = query();  // warm-up, too
        const Timing time = timed([&] { query(); });
        runs.push_back({name, polygons_n, static_cast<double>(m), time, static_cast<double>(found.n_tests()), built,
                        bytes, deviation(found.value, exact)});
      };
      if (n * static_cast<double>(m) <= sizes_.most_products)
        add(brute_force, n, nan, mesh_bytes, [&] { return distances_by_brute_force(polygons, x); });
      add(tree, n, building, tree_bytes, [&] { return tree_of.distances(x); });
      add(tree_within_reach, n, building, tree_bytes, [&] { return tree_of.distances(x, within); });
      const auto shape_bytes = static_cast<double>(sizeof(Superquadric));
      add(analytic_distance, nan, nan, shape_bytes, [&] { return distances_by_surface(partner_, x); });
      add(analytic_function, nan, nan, shape_bytes, [&] { return distances_by_function(function_, x); });
      add(depth_inside, nan, nan, shape_bytes, [&] { return depths_inside(partner_, x); });
    }
  }

 private:
  Timing timed(const std::function<void()>& work) const { return measure(work, sizes_.repeats, sizes_.total); }

  double deviation(const VectorXd& found, const VectorXd& exact) const {
    double largest = 0;
    for (Index i = 0; i < found.size(); ++i)
      if (std::isfinite(found[i]) && std::abs(exact[i]) <= reach_share * size_)
        largest = std::max(largest, std::abs(found[i] - exact[i]));
    return largest;
  }

  const CollisionSizes& sizes_;
  Shape partner_;
  Superquadric function_;
  double size_;
  OverlappingPoints pool_;
};

}  // namespace

CollisionSizes usual_sizes() { return {{2, 3, 4, 6, 8, 11, 16, 32}, 8, 4e7, 5, 0.02}; }

CollisionContest collision_contest(const Shape& body, const Shape& partner, const CollisionSizes& sizes) {
  if (sizes.edges.empty() || sizes.edges.front() < 1 || sizes.fixed < 1)
    throw std::invalid_argument("collision contest: no sizes, or not positive");
  const Contest contest(body, partner, sizes);
  CollisionContest all;
  std::vector<Index> counts;
  for (const int k : sizes.edges) {
    counts.push_back(n_of(k));
    contest.run(k, {n_of(k)}, all.together);
  }
  contest.run(sizes.fixed, counts, all.fixed_polygons);
  return all;
}

}  // namespace mb
