#include "mechanics/geometry/superquadric_quadrature.h"

#include <cmath>

#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/superquadric.h"

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

}  // namespace

Quadrature superquadric_volume_quadrature(const Superquadric& body) {
  const Cones outer = cones(body, 2);
  const Rule radial = gauss_legendre(3);
  const Index n = outer.volume.size();
  Matrix3Xd u(3, 3 * n);
  VectorXd w(3 * n);
  for (int i = 0; i < 3; ++i) {
    u.middleCols(i * n, n) = std::cbrt(radial.x[i]) * outer.u;
    w.segment(i * n, n) = radial.w[i] * outer.volume;
  }
  const Superquadric of_unit_size{Vector3d::Ones(), body.e1, body.e2};
  MatrixXd F(3 * n, 10);
  VectorXd moments(10);
  int column = 0;
  for (int i = 0; i <= 4; i += 2)
    for (int j = 0; i + j <= 4; j += 2)
      for (int k = 0; i + j + k <= 4; k += 2, ++column) {
        F.col(column) = u.row(0).array().pow(i) * u.row(1).array().pow(j) * u.row(2).array().pow(k);
        moments[column] = moment(of_unit_size, i, j, k);
      }
  return {body.semi_axes.asDiagonal() * u, body.semi_axes.prod() * fitted(w, F, moments)};
}

Quadrature superquadric_surface_quadrature(const Superquadric& body) {
  const Cones outer = cones(body, 3);
  const SurfaceMoments known = surface_moments(body);
  MatrixXd F(outer.area.size(), 4);
  F << VectorXd::Ones(outer.area.size()), outer.u.cwiseAbs2().transpose();
  Eigen::Vector4d moments;
  moments << known.area, known.second.cwiseQuotient(body.semi_axes.cwiseAbs2());
  const VectorXd weights = fitted(outer.area, F, moments);
  const Matrix3Xd points = body.semi_axes.asDiagonal() * outer.u;
  if (weights.minCoeff() > 0) return {points, weights};
  return {points, known.area / outer.area.sum() * outer.area};
}

}  // namespace mb
