#include "mechanics/geometry/superquadric_foot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "mechanics/geometry/superquadric_projection.h"
#include "mechanics/geometry/tangents.h"

namespace mb {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr int most_steps = 60;

// |e| that rounding leaves.
double least_miss(const Vector3d& x) { return 1e-15 * (1 + x.norm()); }

// How y and d n move along sigma and tau, in the tangent plane. One unit along a direction is d sigma (or d tau) =
// 1 / weight: lengths stay alike where ratios underflow.
struct Motion {
  Matrix2d point, normal;  // dy, d dn by the two units
  Vector2d weight;         // > 0
};
// Units of which y and n together move by about 1, or (of_point) y alone.
Motion motion(const OctantChart& chart, const Foot& f, bool of_point) {
  const Eigen::Matrix<double, 3, 2> T = tangents(f.at.normal);
  const std::array<ChartTangent, 2> along{chart.by_sigma(f.at), chart.by_tau(f.at)};
  Motion m;
  for (int i = 0; i < 2; ++i) {
    const ChartTangent& t = along[i];
    const double point = of_point ? 1 : t.point_part;
    const double normal = of_point ? std::min(t.gradient_part / t.point_part, 1e10) : t.gradient_part;
    m.point.col(i) = point * (T.transpose() * t.point);
    m.normal.col(i) = normal * f.d / f.at.slope * (T.transpose() * t.gradient);
    m.weight[i] = std::max(of_point ? t.point_weight : t.point_weight + t.gradient_weight, 1e-300);
  }
  return m;
}

Vector2d solved(const Matrix2d& A, const Vector2d& b) {
  return Vector2d(A(1, 1) * b[0] - A(0, 1) * b[1], A(0, 0) * b[1] - A(1, 0) * b[0]) / A.determinant();
}

// A change of sigma or tau, asked for by a linear model, as a change of what is nearly linear in it: with the lesser
// ratio c of the pair, y moves like c, the normal like c^(p-1),
//   point (e^t - 1) + normal / (p - 1) (e^((p-1) t) - 1) = change,   t the growth of log c.
struct Progress {
  double log_ratio, share;  // now; of the greater ratio
  double point, normal;     // lengths by t
  double power;             // p - 1
  double change;            // the linear model's t, times point + normal

  double stepped(double fraction) const {
    const double bend = normal / power, all = point + bend;
    double part = std::max(fraction * change / all, -0.999);
    if (part > 1) {  // at most across the diagonal
      const double most = std::min(std::abs(log_ratio) + 1, 600.0 / std::max(1.0, power));
      part = std::min(part, (point * std::expm1(most) + bend * std::expm1(power * most)) / all);
    }
    double t = std::log1p(part) * all / (point + normal);
    if (std::abs(t) * std::max(1.0, power) > 0.3)
      t = log_root(std::log(point / all), std::log(bend / all), power, std::log1p(part));
    return log_ratio + (log_ratio < 0 ? t : -t) / share;
  }
};
Progress progress(double log_ratio, const Ratios& r, double power, const Motion& m, int i, double units,
                  bool of_point) {
  const double share = log_ratio < 0 ? r.share_second : r.share_first;
  const double point = m.point.col(i).norm(), normal = of_point ? 0 : m.normal.col(i).norm();
  const double t = (log_ratio < 0 ? 1 : -1) * share * units / m.weight[i];
  return {log_ratio, share, point, normal, power, t * (point + normal)};
}

// The first of the points at 1, 1/2, 1/4, ... of the way that is better; nothing where none is.
template <class Better>
std::optional<Foot> searched(const OctantChart& chart, const Vector3d& x, const Foot& f, const Motion& m,
                             const Vector2d& units, bool of_point, const Better& better) {
  const Progress sigma = progress(f.at.sigma, f.at.across, chart.power_p, m, 0, units[0], of_point);
  const Progress tau = progress(f.at.tau, f.at.along, chart.power_q, m, 1, units[1], of_point);
  double fraction = 1;
  for (int k = 0; k < 40; ++k, fraction *= 0.5) {
    const Foot next = foot_at(chart.at(sigma.stepped(fraction), tau.stepped(fraction)), x);
    if (better(next, fraction)) return next;
    if (f.miss < 1e-12 * (1 + x.norm())) return std::nullopt;  // what is left is rounding
  }
  return std::nullopt;
}

Foot newton_outside(const OctantChart& chart, const Vector3d& x, Foot f) {
  const double enough = least_miss(x);
  for (int k = 0; k < most_steps && f.miss > enough; ++k) {
    const Motion m = motion(chart, f, false);
    const Vector2d units = solved(m.point + m.normal, tangents(f.at.normal).transpose() * f.e);
    const auto next = searched(chart, x, f, m, units, false, [&](const Foot& g, double fraction) {
      return g.d > 0 && g.miss <= (1 - 0.1 * fraction) * f.miss;
    });
    if (!next) break;
    f = *next;
  }
  return f;
}

}  // namespace

Foot foot_at(const ChartPoint& at, const Vector3d& x) {
  const Vector3d r = x - at.x;
  const double d = r.dot(at.normal);
  const Vector3d e = r - d * at.normal;
  return {at, d, e, e.norm(), r.squaredNorm()};
}

Foot nearest_foot(const OctantChart& chart, const Vector3d& x) {
  const Foot on_ray = foot_at(chart.on_ray(x), x);
  return on_ray.d >= 0 ? foot_outside(chart, x, on_ray) : foot_inside(chart, x, on_ray);
}

Foot foot_outside(const OctantChart& chart, const Vector3d& x, const Foot& on_ray) {
  const Foot f = newton_outside(chart, x, on_ray);
  if (f.miss <= 1e-12 * (1 + x.norm())) return f;
  const Foot safe = newton_outside(chart, x, foot_at(projection(chart, x), x));
  return safe.miss < f.miss ? safe : f;
}

// With B = dn/dy, the Hessian is 1 + d B by arc length; where it is not positive, its modulus.
Foot minimum_near(const OctantChart& chart, const Vector3d& x, const Foot& from) {
  Foot f = from;
  const double enough = least_miss(x);
  for (int k = 0; k < most_steps && f.miss > enough; ++k) {
    const Motion m = motion(chart, f, true);
    const Matrix2d dB = (m.normal * m.point.inverse()).eval();
    Eigen::SelfAdjointEigenSolver<Matrix2d> spectrum;
    spectrum.computeDirect(Matrix2d::Identity() + 0.5 * (dB + dB.transpose()));
    const Vector2d modulus = spectrum.eigenvalues().cwiseAbs().cwiseMax(1e-6).cwiseMin(1);
    const Vector2d e = tangents(f.at.normal).transpose() * f.e;
    const Vector2d arc = spectrum.eigenvectors() * (spectrum.eigenvectors().transpose() * e).cwiseQuotient(modulus);
    const double slack = enough * std::sqrt(f.squared) + enough * enough;
    const auto next = searched(chart, x, f, m, solved(m.point, arc), true, [&](const Foot& g, double) {
      return g.squared < f.squared - slack || (g.squared <= f.squared + slack && g.miss <= 0.9 * f.miss);
    });
    if (!next) break;
    f = *next;
  }
  return f;
}

}  // namespace mb
