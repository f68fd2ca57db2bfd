// Where the search for the nearest surface point begins for a point inside, and which of the minima found is the least.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mechanics/geometry/superquadric_foot.h"

namespace mb {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int n_by_point = 12, n_by_normal = 6, n_nodes = n_by_point + n_by_normal;

// Logarithms of ratios: of points at equal angles, and for p > 2 of normals at equal angles, which crowd in the corner.
struct Nodes {
  std::array<double, n_nodes> logarithm;
  std::array<Ratios, n_nodes> ratios;
  int n;
};
Nodes nodes(double power) {
  static const auto fixed = [] {
    const auto at_equal_angles = [](int k, int n) { return std::log(std::tan(0.5 * pi * (k + 0.5) / n)); };
    std::array<double, n_nodes> all;
    for (int k = 0; k < n_by_point; ++k) all[k] = at_equal_angles(k, n_by_point);
    for (int k = 0; k < n_by_normal; ++k) all[n_by_point + k] = at_equal_angles(k, n_by_normal);
    return all;
  }();
  Nodes chosen{fixed, {}, power > 1 ? n_nodes : n_by_point};
  for (int k = n_by_point; k < chosen.n; ++k) chosen.logarithm[k] /= power;
  std::sort(chosen.logarithm.begin(), chosen.logarithm.begin() + chosen.n);
  for (int k = 0; k < chosen.n; ++k) chosen.ratios[k] = ratios(chosen.logarithm[k], power);
  return chosen;
}

// |x - y|^2 at all pairs of nodes, and which pairs are local minima among their eight neighbours.
class Grid {
 public:
  Grid(const OctantChart& chart, const Vector3d& x) : across(nodes(chart.power_p)), along(nodes(chart.power_q)) {
    for (int i = 0; i < across.n; ++i)
      for (int j = 0; j < along.n; ++j) {
        const Ratios &in = across.ratios[i], &out = along.ratios[j];
        y_[i][j] = chart.a.cwiseProduct(Vector3d(out.first * in.first, out.first * in.second, out.second));
        squared_[i][j] = (x - y_[i][j]).squaredNorm();
      }
  }
  // A bound from below of |x - y| near the node, where that is a local minimum; else infinite.
  double bound(int i, int j) const {
    double reach = 0;
    for (int k = std::max(i - 1, 0); k <= std::min(i + 1, across.n - 1); ++k)
      for (int l = std::max(j - 1, 0); l <= std::min(j + 1, along.n - 1); ++l) {
        const bool earlier = k < i || (k == i && l < j);  // of equal ones the first
        if (squared_[k][l] < squared_[i][j] || (earlier && squared_[k][l] == squared_[i][j])) return infinite;
        reach = std::max(reach, (y_[k][l] - y_[i][j]).squaredNorm());
      }
    return std::sqrt(squared_[i][j]) - std::sqrt(reach);
  }

  const Nodes across, along;

 private:
  std::array<std::array<double, n_nodes>, n_nodes> squared_;
  std::array<std::array<Vector3d, n_nodes>, n_nodes> y_;
};

// (1 - t^p)^(1/p) of t in (0, 1].
double complement(double t, double p) { return std::pow(std::max(0.0, -std::expm1(p * std::log(t))), 1 / p); }

// The surface points found from x along each axis outward.
std::array<Vector3d, 3> along_axes(const OctantChart& chart, const Vector3d& x) {
  const Vector3d u = x.cwiseQuotient(chart.a);
  const double p = 1 + chart.power_p, q = 1 + chart.power_q;
  const double greater = std::max(u[0], u[1]), lesser = std::min(u[0], u[1]);
  const double r = greater * std::pow(1 + std::pow(lesser / greater, p), 1 / p);
  const double R = complement(std::min(u[2], 1.0), q);
  std::array<Vector3d, 3> y{x, x, x};
  y[0][0] = chart.a[0] * R * complement(std::min(u[1] / std::max(R, 1e-300), 1.0), p);
  y[1][1] = chart.a[1] * R * complement(std::min(u[0] / std::max(R, 1e-300), 1.0), p);
  y[2][2] = chart.a[2] * complement(std::min(r, 1.0), q);
  return y;
}

}  // namespace

Foot foot_inside(const OctantChart& chart, const Vector3d& x, const Foot& on_ray) {
  Foot best = minimum_near(chart, x, on_ray);
  const auto try_from = [&](const ChartPoint& from) {
    const Foot f = minimum_near(chart, x, foot_at(from, x));
    if (f.squared < best.squared) best = f;
  };
  // A foot at the distance d is met along the axis nearest to its normal after about d sqrt(3) at most.
  for (const Vector3d& y : along_axes(chart, x))
    if ((y - x).squaredNorm() < 16 * best.squared) try_from(chart.on_ray(y.cwiseMax(1e-16 * chart.a)));
  const Grid grid(chart, x);
  for (int i = 0; i < grid.across.n; ++i)
    for (int j = 0; j < grid.along.n; ++j)
      if (grid.bound(i, j) < std::sqrt(best.squared))
        try_from(chart.at(grid.across.logarithm[i], grid.along.logarithm[j]));
  return best;
}

}  // namespace mb
