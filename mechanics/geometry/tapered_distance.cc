#include "mechanics/geometry/tapered_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "mechanics/geometry/root.h"
#include "mechanics/geometry/superquadric_distance.h"
#include "mechanics/geometry/tapered.h"

namespace mb {

namespace {

constexpr double sharpest = 1e9;      // curvature times extent above which it counts as that
constexpr double no_pole = 4;         // semi-axis along z by those across of what stands for a superellipse
constexpr double tolerance = 1e-15;   // of tau
constexpr double infinite_tau = 800;  // w = 0: the widest section of the straight body
constexpr int most_halvings = 4;      // between two nodes
constexpr int n_by_point = 12, n_by_slope = 6, n_nodes = n_by_point + n_by_slope;

// How far a section's curve is, and how that changes along Z, times a positive factor.
struct Section {
  double tau, f, w;   // of the profile
  double height;      // [m] of x above it
  double D;           // [m]
  Eigen::Vector2d n;  // [-]
  double slope;
  double distance() const { return std::hypot(D, height); }
};

class Sections {
 public:
  Sections(const TaperedSuperquadric& body, const Vector3d& x, bool outside)
      : body_(body), x_(x), taper_(body), outside_(outside) {}

  Section at(int half, double tau) const {
    const TaperedProfile p = tapered_profile(body_, half, tau);
    const Vector3d& a = body_.straight.semi_axes;
    const double f = std::max(p.radius, 1e-30), across = f * std::max(a[0], a[1]);
    const Superquadric plane{{f * a[0], f * a[1], no_pole * across}, 1, body_.straight.e2};
    const Distance d = superquadric_distance(plane, {x_[0], x_[1], 0});
    const Eigen::Vector2d n = d.gradient.head<2>();
    const double D = outside_ ? std::max(d.value, 0.0) : d.value, support = section_support(body_, n);
    const double height = x_[2] + taper_.shift() - half * a[2] * p.w;
    return {tau, p.radius, p.w, height, D, n, -half * D * support * p.slope - a[2] * height * p.weight};
  }
  double slope(int half, double tau) const { return at(half, tau).slope; }
  double root(int half, double from, double to) const {
    return root_between([&](double tau) { return slope(half, tau); }, from, to, tolerance);
  }

  // The section nearest to x outside: the only one.
  Section nearest_outside() const {
    const int half = slope(1, infinite_tau) < 0 ? 1 : -1;
    return at(half, root(half, -most_tau, most_tau));
  }

  Section nearest_inside() const {
    std::vector<std::pair<int, Section>> looks;
    for (const int half : {-1, 1}) {
      looks.emplace_back(half, at(half, most_tau));
      for (const double tau : nodes()) looks.emplace_back(half, at(half, tau));
    }
    Section best = looks.front().second;
    for (const auto& [half, look] : looks) best = nearer(best, look);
    for (size_t i = 0; i + 1 < looks.size(); ++i)
      if (looks[i].first == looks[i + 1].first)
        best = nearer_between(looks[i].first, looks[i].second, looks[i + 1].second, most_halvings, best);
    return best;
  }

 private:
  // Between two sections the nearest points move by no more than the sections do: on the way from one to the other x
  // comes no nearer than half of what both distances leave of that. Such parts as may hold a nearer one are halved.
  Section nearer_between(int half, const Section& a, const Section& b, int n_halvings, Section best) const {
    const Vector3d& axes = body_.straight.semi_axes;
    const double way = std::hypot((a.f - b.f) * axes.head<2>().norm(), (a.w - b.w) * axes[2]);
    if (0.5 * (a.distance() + b.distance() - way) > best.distance()) return best;
    if (n_halvings == 0) {
      const bool between = half * a.slope < 0 && half * b.slope >= 0;
      return between ? nearer(best, at(half, root(half, a.tau, b.tau))) : best;
    }
    const Section middle = at(half, 0.5 * (a.tau + b.tau));
    best = nearer_between(half, a, middle, n_halvings - 1, nearer(best, middle));
    return nearer_between(half, middle, b, n_halvings - 1, best);
  }
  static const Section& nearer(const Section& a, const Section& b) { return b.distance() < a.distance() ? b : a; }

  // From the widest section to the pole: of points at equal angles, and of normals.
  std::array<double, n_nodes + 1> nodes() const {
    std::array<double, n_nodes + 1> tau;
    const double power = 2 / body_.straight.e1 - 1;
    const auto at_equal_angles = [](int k, int n) { return std::log(std::tan(0.5 * pi * (k + 0.5) / n)); };
    for (int k = 0; k < n_by_point; ++k) tau[static_cast<size_t>(k)] = at_equal_angles(k, n_by_point);
    for (int k = 0; k < n_by_slope; ++k)
      tau[static_cast<size_t>(n_by_point + k)] = std::clamp(at_equal_angles(k, n_by_slope) / power, -30.0, 30.0);
    tau[n_nodes] = -most_tau;
    std::sort(tau.rbegin(), tau.rend());
    return tau;
  }

  const TaperedSuperquadric& body_;
  const Vector3d& x_;
  Taper taper_;
  bool outside_;
};

// N - 1 of the straight body before the taper; beyond its ends positive, too.
double level(const TaperedSuperquadric& body, const Vector3d& x) {
  const Vector3d X = Taper(body).inverse(x);
  const double beyond = std::abs(X[2]) / body.straight.semi_axes[2] - 1;
  return std::max(gauge(body.straight, X) - 1, beyond);
}

// Of points on the surface but for rounding, which meshes and their loads ask for: y = x - d n, d to first order.
constexpr double on_surface = 1e-12;

struct Nearest {
  double d;
  Vector3d n;  // from the foot, as far as that is known
};
Nearest nearest(const TaperedSuperquadric& body, const Vector3d& x) {
  const double N = level(body, x);
  const bool outside = N >= 0;
  const Sections sections(body, x, outside);
  const Section s = outside ? sections.nearest_outside() : sections.nearest_inside();
  const Vector3d away(s.D * s.n[0], s.D * s.n[1], s.height);
  const double d = (outside ? 1 : -1) * away.norm();
  return {d, d != 0 ? Vector3d(away / d) : Vector3d::Zero()};
}

}  // namespace

Distance tapered_distance(const TaperedSuperquadric& body, const Vector3d& x) {
  const double size = bounds(body).sizes().maxCoeff(), N = level(body, x);
  const TaperedBend here = tapered_bend(body, x);
  const bool on = std::abs(N) < on_surface && here.slope > 0;
  const Nearest found = on ? Nearest{N / here.slope, here.normal} : nearest(body, x);
  const double d = found.d;
  const TaperedBend bend = on ? here : tapered_bend(body, x - d * found.n);
  // Next to the surface rounding is all there is of x - y.
  const Vector3d n = std::abs(d) > 1e-6 * size ? found.n : bend.normal;
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 2; ++i) {
    const double k = std::min(bend.curvatures.values[i], sharpest / size);
    const double left = std::max(1 + k * d, k * size / sharpest);
    const Vector3d t = bend.curvatures.directions.col(i);
    if (k > 0) H += std::min(k / left, sharpest / size) * t * t.transpose();
  }
  return {d, n, H};
}

}  // namespace mb
