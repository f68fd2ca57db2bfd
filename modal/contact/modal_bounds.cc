#include "modal/contact/modal_bounds.h"

#include <algorithm>
#include <cmath>

#include "mechanics/geometry/tapered.h"

namespace mb {

namespace {

constexpr int per_degree = 3;  // N / d of Chebyshev's nodes, half that of equal angles: 1 / cos(pi/6) a direction

VectorXd chebyshev_nodes(int n) {
  VectorXd x(n);
  for (int i = 0; i < n; ++i) x[i] = std::cos(pi * (i + 0.5) / n);
  return x;
}

struct Grid {
  Matrix3Xd X;        // [m]
  double factor;      // [-] >= 1
  double half_width;  // [m] w
};

struct Ellipsoid {
  Vector3d centre, semi_axes;  // [m]
};

// About a superquadric, of the axes of its bounding box: in slices along z, in each of which the concave radius f lies
// below the line through its values before. Sections lie in ellipses of 2^(1/2 - e2/2) f.
Ellipsoid ellipsoid_about(const TaperedSuperquadric& body) {
  constexpr int n_slices = 200;
  const Eigen::AlignedBox3d box = bounds(body);
  const double q = 2 / body.straight.e1, widest = box.max()[0] / body.straight.semi_axes[0];
  const double round = body.straight.e2 < 1 ? std::exp2(0.5 - body.straight.e2 / 2) : 1;
  const auto radius = [&](double z) { return (1 + body.taper * z) * std::pow(1 - std::pow(std::abs(z), q), 1 / q); };
  double squared = 0, before = 0, long_before = 0;
  for (int i = 0; i < n_slices; ++i) {
    const double from = -1 + 2.0 * i / n_slices, to = i + 1 == n_slices ? 1 : -1 + 2.0 * (i + 1) / n_slices;
    const double f = i == 0 ? widest : std::min(widest, before + std::max(0.0, before - long_before));
    squared = std::max(squared, std::pow(round * f / widest, 2) + std::max(from * from, to * to));
    long_before = before, before = radius(to);
  }
  return {box.center(), std::sqrt(squared) * box.sizes() / 2};
}

template <class Place>
Grid product(const VectorXd& a, const VectorXd& b, const VectorXd& c, double half_width, const Place& place) {
  Grid grid{Matrix3Xd(3, a.size() * b.size() * c.size()), std::pow(std::cos(pi / (2 * per_degree)), -3), half_width};
  Index p = 0;
  for (const double x : a)
    for (const double y : b)
      for (const double z : c) grid.X.col(p++) = place(x, y, z);
  return grid;
}

// Superquadrics lie in an ellipsoid; what holds there holds on them.
Grid fitted_grid(const Shape& shape, int d) {
  const int n = per_degree * std::max(1, d);
  const VectorXd x = chebyshev_nodes(n), angle = VectorXd::LinSpaced(2 * n, 0, 2 * pi * (1 - 0.5 / n));
  if (const Box* box = std::get_if<Box>(&shape))
    return product(x, x, x, box->size.minCoeff() / 2, [&](double a, double b, double c) {
      return Vector3d(0.5 * box->size.cwiseProduct(Vector3d(a, b, c)));
    });
  if (const Cylinder* c = std::get_if<Cylinder>(&shape))
    return product(x, angle, x, std::min(c->radius, c->length / 2), [&](double r, double phi, double z) {
      return Vector3d(c->radius * r * std::cos(phi), c->radius * r * std::sin(phi), c->length / 2 * z);
    });
  if (const Sphere* s = std::get_if<Sphere>(&shape))
    return product(x, angle, angle, s->radius, [&](double r, double phi, double theta) {
      return Vector3d(s->radius * r *
                      Vector3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
    });
  const auto* straight = std::get_if<Superquadric>(&shape);
  const Ellipsoid hull =
      ellipsoid_about(straight ? TaperedSuperquadric{*straight, 0} : std::get<TaperedSuperquadric>(shape));
  return product(x, angle, angle, hull.semi_axes.minCoeff(), [&](double r, double phi, double theta) -> Vector3d {
    return hull.centre + r * hull.semi_axes.cwiseProduct(Vector3d(std::sin(theta) * std::cos(phi),
                                                                  std::sin(theta) * std::sin(phi), std::cos(theta)));
  });
}

void tighten(ShapeBounds& bounds, const Shape& shape, const PolynomialBasis& geometry) {
  const int d = geometry.monomials().degree();
  if (geometry.size() == 0) return;
  const Grid grid = fitted_grid(shape, d);
  VectorXd largest = VectorXd::Zero(geometry.size());
  for (Index from = 0; from < grid.X.cols(); from += 1024) {
    const Index n = std::min<Index>(1024, grid.X.cols() - from);
    const MatrixXd phi = geometry.at(grid.X.middleCols(from, n));
    for (Index k = 0; k < phi.cols(); ++k)
      largest[k] = std::max(largest[k], phi.col(k).reshaped(3, n).colwise().squaredNorm().maxCoeff());
  }
  largest = largest.cwiseSqrt() * grid.factor;  // each component along a fixed direction is such a polynomial
  const double w = grid.half_width;
  bounds.value = bounds.value.cwiseMin(largest);
  bounds.gradient = bounds.gradient.cwiseMin(d * d / w * largest);
  bounds.bend = bounds.bend.cwiseMin(d * d * (d - 1) * (d - 1) / (w * w) * largest);
}

}  // namespace

ShapeBounds shape_bounds(const Shape& shape, const PolynomialBasis& geometry) {
  const Index r = geometry.size();
  ShapeBounds bounds{VectorXd::Zero(r), VectorXd::Zero(r), VectorXd::Zero(r)};
  const Vector3d h = geometry.monomials().half_extents();
  for (Index j = 0; j < r; ++j)
    for (Index k = 0; k < geometry.monomials().size(); ++k) {
      const double a = geometry.coefficients().col(j).segment<3>(3 * k).norm();
      if (a == 0) continue;
      const auto e = Monomials::exponents(k);
      Vector3d slope;
      Eigen::Matrix3d curvature;
      for (int m = 0; m < 3; ++m) {
        slope[m] = e[m] / h[m];
        for (int l = 0; l < 3; ++l) curvature(m, l) = e[m] * (e[l] - (m == l ? 1 : 0)) / (h[m] * h[l]);
      }
      bounds.value[j] += a;
      bounds.gradient[j] += a * slope.norm();
      bounds.bend[j] += a * curvature.norm();
    }
  tighten(bounds, shape, geometry);
  return bounds;
}

AmplitudeBounds amplitude_bounds(const FloatingBody& body, const VectorXd& q, const VectorXd& p, double duration) {
  const Index r = body.n_modes();
  AmplitudeBounds bounds{VectorXd(r), VectorXd(r), VectorXd(r)};
  for (Index i = 0; i < r; ++i) {
    const Roots& mode = body.modes[static_cast<size_t>(i)];
    const double w = std::abs(body.weight[i]), c = 2 * mode.h;
    if (mode.k == 0) {
      bounds.p[i] = std::abs(p[i]) + w * duration;
      bounds.q[i] = std::abs(q[i]) + bounds.p[i] * duration;
      bounds.a[i] = w + c * bounds.p[i];
      continue;
    }
    const double rest = body.weight[i] / mode.k, off = q[i] - rest;
    const double energy = 0.5 * (p[i] * p[i] + mode.k * off * off);
    bounds.q[i] = std::sqrt(2 * energy / mode.k) + std::abs(rest);
    bounds.p[i] = std::sqrt(2 * energy);
    bounds.a[i] = mode.omega * bounds.p[i] + c * bounds.p[i];
  }
  return bounds;
}

}  // namespace mb
