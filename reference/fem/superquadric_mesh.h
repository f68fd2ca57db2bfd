// Hexahedra in a superquadric, tapered or not: the ball's seven blocks, of which every boundary point u, |u| = 1, goes
// to
//
//   x = taper(y / N(y)),   y_i = a_i u_i,   N the gauge (superquadric.h, tapered.h)
//
// so that the blocks' edges lie where those of a rounded box do, along |u_1| = |u_2| = |u_3|. New points on the surface
// are the ball's, at equal angles, through this map; what lies inside is blended from them.
#pragma once

#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>

#include "mechanics/geometry/tapered.h"

namespace mb::fem {

// Of the surface.
class SuperquadricManifold final : public dealii::Manifold<3> {
 public:
  using Point = dealii::Point<3>;

  explicit SuperquadricManifold(const TaperedSuperquadric& body);
  std::unique_ptr<dealii::Manifold<3>> clone() const override;
  Point get_new_point(const dealii::ArrayView<const Point>& points,
                      const dealii::ArrayView<const double>& weights) const override;
  void get_new_points(const dealii::ArrayView<const Point>& points, const dealii::Table<2, double>& weights,
                      dealii::ArrayView<Point> new_points) const override;

  Point from_ball(const Point& u) const;  // u [-] of unit length

 private:
  std::vector<Point> to_ball(const dealii::ArrayView<const Point>& points) const;

  TaperedSuperquadric body_;
  Taper taper_;
  dealii::SphericalManifold<3> ball_;
};

// Every edge of the blocks halved so often.
void make_superquadric(dealii::Triangulation<3>& mesh, const TaperedSuperquadric& body, int n_halvings);

}  // namespace mb::fem
