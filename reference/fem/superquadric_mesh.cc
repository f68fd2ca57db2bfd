#include "reference/fem/superquadric_mesh.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace mb::fem {

namespace {

using Point = dealii::Point<3>;

Vector3d vector(const Point& p) { return {p[0], p[1], p[2]}; }
Point point(const Vector3d& x) { return {x[0], x[1], x[2]}; }

constexpr dealii::types::manifold_id curved = 0;

}  // namespace

SuperquadricManifold::SuperquadricManifold(const TaperedSuperquadric& body) : body_(body), taper_(body) {}

std::unique_ptr<dealii::Manifold<3>> SuperquadricManifold::clone() const {
  return std::make_unique<SuperquadricManifold>(body_);
}

Point SuperquadricManifold::from_ball(const Point& u) const {
  const Vector3d y = body_.straight.semi_axes.cwiseProduct(vector(u));
  return point(taper_.apply(y / gauge(body_.straight, y)));
}

std::vector<Point> SuperquadricManifold::to_ball(const dealii::ArrayView<const Point>& points) const {
  std::vector<Point> u;
  for (const Point& p : points)
    u.push_back(point(taper_.inverse(vector(p)).cwiseQuotient(body_.straight.semi_axes).normalized()));
  return u;
}

Point SuperquadricManifold::get_new_point(const dealii::ArrayView<const Point>& points,
                                          const dealii::ArrayView<const double>& weights) const {
  const std::vector<Point> u = to_ball(points);
  return from_ball(ball_.get_new_point({u.data(), u.size()}, weights));
}

void SuperquadricManifold::get_new_points(const dealii::ArrayView<const Point>& points,
                                          const dealii::Table<2, double>& weights,
                                          dealii::ArrayView<Point> new_points) const {
  const std::vector<Point> u = to_ball(points);
  ball_.get_new_points({u.data(), u.size()}, weights, new_points);
  for (Point& p : new_points) p = from_ball(p);
}

void make_superquadric(dealii::Triangulation<3>& mesh, const TaperedSuperquadric& body, int n_halvings) {
  const SuperquadricManifold manifold(body);
  const Taper taper(body);
  dealii::GridGenerator::hyper_ball(mesh);
  dealii::GridTools::transform(
      [&](const Point& u) {
        const double r = u.norm();
        if (r > 0.9) return manifold.from_ball(Point(u / r));
        return point(taper.apply(body.straight.semi_axes.cwiseProduct(vector(u))));
      },
      mesh);
  mesh.reset_all_manifolds();
  mesh.set_all_manifold_ids(dealii::numbers::flat_manifold_id);
  mesh.set_all_manifold_ids_on_boundary(curved);
  mesh.set_manifold(curved, manifold);
  mesh.refine_global(static_cast<unsigned>(n_halvings));
}

}  // namespace mb::fem
