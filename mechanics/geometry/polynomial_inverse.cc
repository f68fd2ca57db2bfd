// The inverse of a polynomial map: Newton with halved steps. All of it about the centre, in scaled coordinates: there
// the residual is free of the rounding of a far-off origin.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/polynomial_map.h"

namespace mb {

namespace {

constexpr double tolerance = 1e-13;  // [-] residual over the extent

// The longest part <= 1 of step d from xi that stays in |xi| <= reach.
double inside(const Vector3d& xi, const Vector3d& d, double reach) {
  double t = 1;
  for (Index a = 0; a < 3; ++a)
    if (std::abs(xi[a] + d[a]) > reach) t = std::min(t, (std::copysign(reach, d[a]) - xi[a]) / d[a]);
  return t;
}

}  // namespace

std::optional<Vector3d> PolynomialMap::newton(const Vector3d& target, const Vector3d& start, int max_steps) const {
  // Parts of a Newton step. Shorter ones than these creep along a fold, or out of the region of validity.
  constexpr double shortest = 1e-3, outward = 0.05;
  const double small = tolerance * std::max(monomials_.extent(), target.norm());
  Vector3d xi = start;
  Point now = about_centre(xi);
  Vector3d residual = target - now.x;
  for (int step = 0; now.F.determinant() > 0; ++step) {
    if (residual.norm() <= small) return xi;
    if (step == max_steps) return {};
    const Vector3d d = now.F.partialPivLu().solve(residual).cwiseQuotient(monomials_.half_extents());
    if (!d.allFinite()) return {};
    double t = inside(xi, d, reach);
    if (!(t >= outward)) return {};
    Point next = about_centre(xi + t * d);
    while (!((target - next.x).norm() <= (1 - 1e-4 * t) * residual.norm() && next.F.determinant() > 0)) {
      t /= 2;
      if (!(t >= shortest)) return {};
      next = about_centre(xi + t * d);
    }
    xi += t * d;
    now = next;
    residual = target - now.x;
  }
  return {};
}

std::optional<Vector3d> PolynomialMap::newton_from_nearest(const Vector3d& target, int max_steps) const {
  constexpr int n_starts = 27, n_tried = 3;
  constexpr double spread = 0.75;  // [-] between the middle of the box's octants and its faces
  struct Start {
    double distance;  // [m]
    Vector3d xi;
  };
  std::array<Start, n_starts> starts;
  for (int i = 0; i < n_starts; ++i) {
    const Vector3d xi = spread * Vector3d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    starts[static_cast<size_t>(i)] = {(target - about_centre(xi).x).norm(), xi};
  }
  std::partial_sort(starts.begin(), starts.begin() + n_tried, starts.end(),
                    [](const Start& a, const Start& b) { return a.distance < b.distance; });
  for (size_t i = 0; i < n_tried; ++i)
    if (const auto xi = newton(target, starts[i].xi, max_steps)) return xi;
  return {};
}

std::optional<Vector3d> PolynomialMap::inverse(const Vector3d& x, const std::optional<Vector3d>& guess,
                                               int max_steps) const {
  if (!x.allFinite() || (guess && !guess->allFinite()))
    throw std::invalid_argument("inverse of a polynomial map: the point or its guess is not finite");
  if (max_steps < 1) throw std::invalid_argument("inverse of a polynomial map: at least one step");
  const Vector3d target = x - monomials_.centre();
  if ((target.cwiseAbs().array() > range_.array()).any()) return {};
  const double limit = guess ? reach : 1;
  const Vector3d start = monomials_.scaled(guess.value_or(x)).cwiseMax(-limit).cwiseMin(limit);
  auto xi = newton(target, start, max_steps);
  if (!xi) xi = newton_from_nearest(target, max_steps);
  if (!xi) return {};
  return monomials_.centre() + monomials_.half_extents().cwiseProduct(*xi);
}

}  // namespace mb
