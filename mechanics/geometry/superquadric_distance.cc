#include "mechanics/geometry/superquadric_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mechanics/geometry/superquadric_foot.h"
#include "mechanics/geometry/superquadric_valid.h"
#include "mechanics/geometry/tangents.h"

namespace mb {

namespace {

constexpr double sharpest = 1e9;    // curvature times extent above which it counts as that
constexpr double farthest = 1e15;   // in units of the chart: from there on directions do not change
constexpr double smallest = 1e-16;  // coordinate, by its semi-axis, as which 0 counts

// x in the chart's octant and units.
struct Query {
  OctantChart chart;
  Vector3d x;   // [-] > 0
  double unit;  // [m] of the results: the chart's, where x is beyond `farthest` of those as much more
};
Query query(const Superquadric& body, const Vector3d& x) {
  require_valid(body);
  const OctantChart chart(body);
  const double greatest = x.cwiseAbs().maxCoeff();
  const double unit = std::max(chart.unit, greatest / farthest);
  return {chart, (x.cwiseAbs() / unit).cwiseMax(smallest * chart.a), unit};
}

// k / (1 + k d) in the tangent plane: dn / dx, of dn and dx along the chart's two directions.
Eigen::Matrix2d bending(const OctantChart& chart, const Foot& f, const Eigen::Matrix<double, 3, 2>& T) {
  Eigen::Matrix2d turn, shift;
  const std::array<ChartTangent, 2> along{chart.by_sigma(f.at), chart.by_tau(f.at)};
  for (int i = 0; i < 2; ++i) {
    turn.col(i) = along[i].gradient_part / f.at.slope * T.transpose() * along[i].gradient;
    shift.col(i) = along[i].point_part * T.transpose() * along[i].point + f.d * turn.col(i);
  }
  // Oriented like the surface, the determinant is positive where y is nearest, 0 in a centre of curvature.
  const double area = std::max(shift.determinant(), 1e-40);
  Eigen::Matrix2d adjugate;
  adjugate << shift(1, 1), -shift(0, 1), -shift(1, 0), shift(0, 0);
  const Eigen::Matrix2d H = turn * adjugate / area;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spectrum =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>().computeDirect(0.5 * (H + H.transpose()));
  const Eigen::Vector2d kept = spectrum.eigenvalues().cwiseMin(0.5 * sharpest).cwiseMax(0);
  return spectrum.eigenvectors() * kept.asDiagonal() * spectrum.eigenvectors().transpose();
}

}  // namespace

Distance superquadric_distance(const Superquadric& body, const Vector3d& x) {
  const Query q = query(body, x);
  const Foot f = nearest_foot(q.chart, q.x);
  const Vector3d signs = x.unaryExpr([](double c) { return c < 0 ? -1.0 : 1.0; });
  const Vector3d n = signs.cwiseProduct(f.at.normal);
  const Eigen::Matrix<double, 3, 2> T = tangents(f.at.normal);
  const Eigen::Matrix3d H = T * bending(q.chart, f, T) * T.transpose() / q.unit;
  return {f.d * q.unit, n, signs.asDiagonal() * H * signs.asDiagonal()};
}

double superquadric_distance_value(const Superquadric& body, const Vector3d& x) {
  const Query q = query(body, x);
  return nearest_foot(q.chart, q.x).d * q.unit;
}

}  // namespace mb
