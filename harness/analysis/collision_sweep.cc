#include "harness/analysis/collision_sweep.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/geometry/overloaded.h"
#include "mechanics/geometry/signed_distance.h"
#include "mechanics/geometry/tapered.h"

namespace mb {

namespace {

constexpr Index most_points = 200'000;

// One in the middle of each polygon. Of polygons 2k and 2k + 1, halves of one cell, neither comes first everywhere.
Matrix3Xd middles(const TriangleMesh& mesh) {
  Matrix3Xd x(3, mesh.triangles.cols());
  for (Index i = 0; i < x.cols(); ++i)
    x.col(i) = (mesh.vertices.col(mesh.triangles(0, i)) + mesh.vertices.col(mesh.triangles(1, i)) +
                mesh.vertices.col(mesh.triangles(2, i))) /
               3;
  return x;
}

double least_distance(const Shape& partner, const Matrix3Xd& x, double shift) {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < x.cols(); ++i)
    least = std::min(least, signed_distance_value(partner, x.col(i) + shift * Vector3d::UnitZ()));
  return least;
}

}  // namespace

Vector3d half_extents(const Shape& shape) {
  return std::visit(overloaded{[](const Box& b) { return Vector3d(b.size / 2); },
                               [](const Cylinder& c) { return Vector3d(c.radius, c.radius, c.length / 2); },
                               [](const Sphere& s) { return Vector3d(s.radius, s.radius, s.radius); },
                               [](const Superquadric& s) { return s.semi_axes; },
                               [](const TaperedSuperquadric& s) { return Vector3d(bounds(s).sizes() / 2); }},
                    shape);
}

Sphere sphere_of_size(const Shape& body) { return {half_extents(body).maxCoeff()}; }
Superquadric superquadric_of_size(const Shape& body) { return {half_extents(body), 0.5, 0.5}; }
Superquadric as_superquadric(const Sphere& sphere) { return {Vector3d::Constant(sphere.radius), 1, 1}; }

OverlappingPoints::OverlappingPoints(const Shape& body, const Shape& partner, double overlap) {
  if (!(overlap > 0) || !std::isfinite(overlap)) throw std::invalid_argument("overlap: not positive");
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Vector3d(0.8, 0.5, 0.3).normalized()).toRotationMatrix();
  all_ = turn * middles(triangulate(body, 80));
  const Matrix3Xd coarse = turn * middles(triangulate(body, 8));
  // The partner is convex: from its middle upwards the least distance grows.
  double low = 0, high = 4 * (half_extents(body).norm() + half_extents(partner).norm());
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (least_distance(partner, coarse, middle) < -overlap ? low : high) = middle;
  }
  all_.row(2).array() += high;
}

Matrix3Xd OverlappingPoints::points(Index m) const {
  if (m < 1 || m > most_points) throw std::invalid_argument("overlap: the number of points is out of range");
  Matrix3Xd x(3, m);
  constexpr double golden = 0.6180339887498949;  // of equidistributed places those of any number are
  for (Index i = 0; i < m; ++i) {
    const double place = std::fmod(golden * static_cast<double>(i + 1), 1.0);
    x.col(i) = all_.col(static_cast<Index>(place * static_cast<double>(all_.cols())));
  }
  return x;
}

double crossover(const VectorXd& x, const VectorXd& cost, const VectorXd& other) {
  if (x.size() == 0 || cost.size() != x.size() || other.size() != x.size())
    throw std::invalid_argument("crossover: costs of other sizes than were asked for");
  if (!((x.array() > 0) && (cost.array() > 0) && (other.array() > 0)).all())
    throw std::invalid_argument("crossover: a size or a cost is not positive");
  const VectorXd r = (cost.array() / other.array()).log();
  Index i = r.size() - 1;
  if (!(r[i] < 0)) return std::numeric_limits<double>::quiet_NaN();
  while (i > 0 && r[i - 1] < 0) --i;
  if (i == 0) return x[0];
  return x[i - 1] * std::pow(x[i] / x[i - 1], r[i - 1] / (r[i - 1] - r[i]));
}

}  // namespace mb
