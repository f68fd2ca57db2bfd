#include "modal/contact/modal_bounds.h"

#include <cmath>

namespace mb {

ShapeBounds shape_bounds(const PolynomialBasis& geometry) {
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
