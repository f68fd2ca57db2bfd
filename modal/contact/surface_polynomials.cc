#include "modal/contact/surface_polynomials.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "mechanics/contact/first_touch_support.h"
#include "mechanics/geometry/signed_distance.h"
#include "modal/contact/sample_tables.h"

namespace mb {

namespace {

constexpr double as_good = 2, exact = 3e-4;  // [-] of a residual
constexpr int n_across = 9;                  // points along each axis: degree 8 and one more

// The least degree that will do, of a fit of the highest.
int least_degree(const Regression& fit) {
  int degree = 0;
  for (const ModeFit& mode : fit.modes) {
    const VectorXd& left = mode.residual_by_degree;
    const double enough = as_good * left[left.size() - 1] + exact;
    while (degree + 1 < left.size() && !(left[degree] <= enough)) ++degree;
  }
  return degree;
}

Regression fitted(const Vector3d& centre, const Vector3d& half, const Matrix3Xd& X, const VectorXd& w,
                  const MatrixXd& U) {
  const Regression fit = regress(Monomials(max_polynomial_degree, centre, half), X, w, U);
  const int degree = least_degree(fit);
  return degree < max_polynomial_degree ? regress(Monomials(degree, centre, half), X, w, U) : fit;
}

}  // namespace

Regression polynomials_of(const BodyModel& mesh, const MatrixXd& Phi_at_points) {
  const auto& [volume, surface, probes] = mesh.points;
  Vector3d half = Vector3d::Zero();
  for (const Quadrature* rule : {&volume, &surface}) half = half.cwiseMax(rule->points.cwiseAbs().rowwise().maxCoeff());
  const Index n = volume.points.cols() + surface.points.cols();
  VectorXd w(n);
  w << volume.weights / volume.weights.sum(), surface.weights / surface.weights.sum();
  return fitted(Vector3d::Zero(), half, mesh.points.all().leftCols(n), w, Phi_at_points.topRows(3 * n));
}

Regression polynomials_near(const Shape& shape, const FullModel& full, const MatrixXd& Phi, const Vector3d& X,
                            double reach) {
  Vector3d least, most;
  for (Index i = 0; i < 3; ++i) {
    least[i] = support_point(shape, -Vector3d::Unit(i))[i];
    most[i] = support_point(shape, Vector3d::Unit(i))[i];
  }
  const Vector3d low = (X.array() - reach).matrix().cwiseMax(least), high = (X.array() + reach).matrix().cwiseMin(most),
                 centre = (low + high) / 2, half = (high - low) / 2;
  const auto along = [](Index i) { return -std::cos(pi * (static_cast<double>(i) + 0.5) / n_across); };  // Chebyshev's
  std::vector<Vector3d> inside;
  for (Index i = 0; i < n_across; ++i)
    for (Index j = 0; j < n_across; ++j)
      for (Index k = 0; k < n_across; ++k) {
        const Vector3d at = centre + half.cwiseProduct(Vector3d(along(i), along(j), along(k)));
        if (signed_distance_value(shape, at) <= 0) inside.push_back(at);
      }
  Matrix3Xd points(3, std::ssize(inside));
  for (size_t i = 0; i < inside.size(); ++i) points.col(static_cast<Index>(i)) = inside[i];
  return fitted(centre, half, points, VectorXd::Ones(points.cols()), full.displacement_at(points) * Phi);
}

PartnerSurface partner_surface(size_t body, const Shape& shape, PolynomialBasis geometry, Matrix3Xd feet,
                               const MatrixXd& Psi) {
  const Monomials& m = geometry.monomials();
  Matrix3Xd near = surface_quadrature(shape).points;  // within the box of the polynomials: beyond they mean nothing
  for (Index i = 0; i < near.cols(); ++i)
    near.col(i) = m.centre() + m.half_extents().cwiseProduct(m.scaled(Vector3d(near.col(i))).cwiseMax(-1).cwiseMin(1));
  VectorXd largest_q = largest_displacements(geometry.at(near));
  return {body,
          shape,
          std::move(geometry),
          std::move(feet),
          Psi.transpose(),
          circumradius(shape),
          std::move(largest_q),
          largest_displacements(Psi)};
}

}  // namespace mb
