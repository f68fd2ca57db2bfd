#include "modal/polygons/polygon_contact.h"

#include <limits>
#include <stdexcept>

#include "mechanics/geometry/signed_distance.h"
#include "mechanics/geometry/superquadric.h"
#include "mechanics/geometry/superquadric_distance.h"

namespace mb {

void require_finite_points(const Matrix3Xd& points) {
  if (!points.allFinite()) throw std::invalid_argument("distances of points: a point is not finite");
}

PointDistances distances_by_brute_force(const Polygons& polygons, const Matrix3Xd& points) {
  require_finite_points(points);
  PointDistances found{VectorXd(points.cols())};
  for (Index j = 0; j < points.cols(); ++j) {
    const Vector3d x = points.col(j);
    NearestOnTriangle best = polygons.nearest(0, x);
    Index of = 0;
    for (Index i = 1; i < polygons.size(); ++i)
      if (const NearestOnTriangle next = polygons.nearest(i, x); next.squared_distance < best.squared_distance) {
        best = next;
        of = i;
      }
    found.value[j] = polygons.signed_distance(of, x, best);
  }
  found.n_triangles = points.cols() * polygons.size();
  return found;
}

PointDistances distances_by_surface(const Shape& shape, const Matrix3Xd& points) {
  require_finite_points(points);
  PointDistances found{VectorXd(points.cols())};
  for (Index j = 0; j < points.cols(); ++j) found.value[j] = signed_distance_value(shape, points.col(j));
  found.n_functions = points.cols();
  return found;
}

// At the centre, where N has no gradient, by the least semi-axis.
PointDistances distances_by_function(const Superquadric& body, const Matrix3Xd& points) {
  require_finite_points(points);
  PointDistances found{VectorXd(points.cols())};
  for (Index j = 0; j < points.cols(); ++j) {
    const GaugeDerivatives N = gauge_derivatives(body, points.col(j));
    const double slope = N.gradient.norm();
    found.value[j] = (N.value - 1) * (slope > 0 ? 1 / slope : body.semi_axes.minCoeff());
  }
  found.n_functions = points.cols();
  return found;
}

namespace {

PointDistances depths_inside(const Superquadric& body, const Matrix3Xd& points) {
  PointDistances found{VectorXd(points.cols())};
  found.n_boxes = points.cols();
  for (Index j = 0; j < points.cols(); ++j) {
    const Vector3d x = points.col(j);
    found.value[j] = std::numeric_limits<double>::infinity();
    if ((x.array().abs() > body.semi_axes.array()).any()) continue;
    ++found.n_functions;
    if (!(gauge(body, x) < 1)) continue;
    found.value[j] = superquadric_distance_value(body, x);
    ++found.n_functions;
  }
  return found;
}

}  // namespace

PointDistances depths_inside(const Shape& shape, const Matrix3Xd& points) {
  require_finite_points(points);
  if (const auto* body = std::get_if<Superquadric>(&shape)) return depths_inside(*body, points);
  PointDistances found = distances_by_surface(shape, points);
  for (double& d : found.value)
    if (d >= 0) d = std::numeric_limits<double>::infinity();
  return found;
}

}  // namespace mb
