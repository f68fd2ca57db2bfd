#include "mechanics/geometry/superquadric_quadrature.h"

#include <array>
#include <cmath>
#include <vector>

#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/tapered.h"

namespace mb {

namespace {

// Measures at y (superquadric_measure.cc): the cone of a surface element from the centre a1 a2 a3 / (3 N^3), its area
// that times 3 |grad N|; here without the factors that all points share.
struct Cones {
  Matrix3Xd u;            // [-] x_i / a_i on the surface
  VectorXd volume, area;  // relative weights
};
Cones cones(const Superquadric& body, int n) {
  const Rule gauss = gauss_legendre(n);
  Cones all{Matrix3Xd(3, 24 * n * n), VectorXd(24 * n * n), VectorXd(24 * n * n)};
  Index at = 0;
  for (int face = 0; face < 24; ++face)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j, ++at) {
        const double s = std::tan(0.25 * pi * gauss.x[i]), t = std::tan(0.25 * pi * gauss.x[j]);
        const int axis = face / 8;
        Vector3d u;
        u[axis] = face & 1 ? -1 : 1;
        u[(axis + 1) % 3] = face & 2 ? -s : s;
        u[(axis + 2) % 3] = face & 4 ? -t : t;
        const GaugeDerivatives N = gauge_derivatives(body, body.semi_axes.cwiseProduct(u));
        all.u.col(at) = u / N.value;
        all.volume[at] = gauss.w[i] * gauss.w[j] * (1 + s * s) * (1 + t * t) / (N.value * N.value * N.value);
        all.area[at] = all.volume[at] * N.gradient.norm();
      }
  return all;
}

// w (1 + F c) with F^T w (1 + F c) = moments: of all such weights the nearest to w in the sum of (change / w)^2 w. The
// first column of F is 1: its moment, the measure, is met to rounding.
VectorXd fitted(const VectorXd& w, const MatrixXd& F, const VectorXd& moments) {
  const VectorXd scaled = moments[0] / w.sum() * w;
  const MatrixXd gram = F.transpose() * scaled.asDiagonal() * F;
  const VectorXd c = gram.ldlt().solve(moments - F.transpose() * scaled);
  const VectorXd changed = scaled.array() * (1 + (F * c).array());
  return moments[0] / changed.sum() * changed;
}

TaperedSuperquadric of_unit_size(const TaperedSuperquadric& body) {
  return {{Vector3d::Ones(), body.straight.e1, body.straight.e2}, body.taper};
}

// Moments of that degree and less that are not 0 by symmetry.
VectorXd fitted_to_degree(int degree, const TaperedSuperquadric& unit, const Matrix3Xd& u, const VectorXd& w) {
  const int step = unit.taper == 0 ? 2 : 1;  // odd ones along z
  std::vector<std::array<int, 3>> powers;
  for (int i = 0; i <= degree; i += 2)
    for (int j = 0; i + j <= degree; j += 2)
      for (int k = 0; i + j + k <= degree; k += step) powers.push_back({i, j, k});
  MatrixXd F(w.size(), std::ssize(powers));
  VectorXd moments(F.cols());
  for (Index column = 0; column < F.cols(); ++column) {
    const auto& [i, j, k] = powers[static_cast<size_t>(column)];
    F.col(column) = u.row(0).array().pow(i) * u.row(1).array().pow(j) * u.row(2).array().pow(k);
    moments[column] = moment(unit, i, j, k);
  }
  return fitted(w, F, moments);
}

}  // namespace

Quadrature superquadric_volume_quadrature(const Superquadric& body) {
  return superquadric_volume_quadrature(TaperedSuperquadric{body, 0});
}
Quadrature superquadric_surface_quadrature(const Superquadric& body) {
  return superquadric_surface_quadrature(TaperedSuperquadric{body, 0});
}

Quadrature superquadric_volume_quadrature(const TaperedSuperquadric& body) {
  const TaperedSuperquadric unit = of_unit_size(body);
  const Taper taper(unit);
  const Cones outer = cones(body.straight, 2);
  const Rule radial = gauss_legendre(3);
  const Index n = outer.volume.size();
  Matrix3Xd u(3, 3 * n);
  VectorXd w(3 * n);
  for (int i = 0; i < 3; ++i)
    for (Index j = 0; j < n; ++j) {
      const Vector3d U = std::cbrt(radial.x[i]) * outer.u.col(j);
      const double c = taper.factor(U[2]);
      u.col(i * n + j) = taper.apply(U);
      w[i * n + j] = radial.w[i] * outer.volume[j] * c * c;
    }
  const Vector3d& a = body.straight.semi_axes;
  VectorXd weights = fitted_to_degree(5, unit, u, w);
  if (!(weights.minCoeff() > 0)) weights = fitted_to_degree(3, unit, u, w);
  return {a.asDiagonal() * u, a.prod() * weights};
}

Quadrature superquadric_surface_quadrature(const TaperedSuperquadric& body) {
  const Superquadric& straight = body.straight;
  const Vector3d& a = straight.semi_axes;
  const Taper taper(body);
  const Cones outer = cones(straight, 3);
  const Index n = outer.area.size();
  Matrix3Xd x(3, n);
  VectorXd area = outer.area;
  for (Index i = 0; i < n; ++i) {
    const Vector3d X = a.cwiseProduct(outer.u.col(i)), normal = outward_normal(straight, X);
    x.col(i) = taper.apply(X);
    if (body.taper != 0) area[i] *= taper.area(X, normal).norm();
  }
  const SurfaceMoments known = surface_moments(body);
  const Matrix3Xd u = a.cwiseInverse().asDiagonal() * x;
  MatrixXd F(n, body.taper == 0 ? 4 : 5);
  VectorXd moments(F.cols());
  F.leftCols(4) << VectorXd::Ones(n), u.cwiseAbs2().transpose();
  moments.head(4) << known.area, known.second.cwiseQuotient(a.cwiseAbs2());
  if (body.taper != 0) {
    F.col(4) = u.row(2);
    moments[4] = known.first / a[2];
  }
  const VectorXd weights = fitted(area, F, moments);
  if (weights.minCoeff() > 0) return {x, weights};
  return {x, known.area / area.sum() * area};
}

}  // namespace mb
