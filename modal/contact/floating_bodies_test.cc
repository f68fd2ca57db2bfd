#include "modal/contact/floating_bodies_test.h"

#include "mechanics/geometry/pose.h"

namespace mb::testing {

Vector3d half_box(const Shape& shape) {
  Vector3d half;
  for (int i = 0; i < 3; ++i) half[i] = support_point(shape, Vector3d::Unit(i))[i];
  return half;
}

PolynomialBasis no_modes(const Shape& shape) {
  return {Monomials(1, Vector3d::Zero(), half_box(shape)), MatrixXd(12, 0)};
}

PolynomialBasis random_modes(const Shape& shape, int degree, Index r, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const Monomials monomials(degree, Vector3d::Zero(), half_box(shape));
  MatrixXd a(3 * monomials.size(), r);
  for (double& x : a.reshaped()) x = size / std::sqrt(static_cast<double>(monomials.size())) * normal(random);
  return {monomials, a};
}

PolynomialBasis momentless_modes(const Shape& shape, int degree, Index r, unsigned seed) {
  const Monomials monomials(degree, Vector3d::Zero(), half_box(shape));
  MatrixXd a = MatrixXd::Zero(3 * monomials.size(), 6 + r);
  for (Index i = 0; i < 3; ++i) {
    a(i, i) = 1;
    for (Index k = 0; k < 3; ++k)  // e_i x X
      a.block<3, 1>(3 * monomial_index(k == 0, k == 1, k == 2), 3 + i) =
          monomials.half_extents()[k] * Vector3d::Unit(i).cross(Vector3d::Unit(k));
  }
  a.rightCols(r) = random_modes(shape, degree, r, 1, seed).coefficients();
  const Quadrature volume = volume_quadrature(shape);
  const MatrixXd P = PolynomialBasis(monomials, a).at(volume.points);
  const VectorXd mass = 1000 * volume.weights.replicate(1, 3).transpose().reshaped();
  const MatrixXd G = P.transpose() * mass.asDiagonal() * P;
  const MatrixXd of_unit_mass = G.llt().matrixU().solve<Eigen::OnTheRight>(a);
  return {monomials, of_unit_mass.rightCols(r)};
}

PolynomialBasis swelling(double radius, double size) {
  MatrixXd a = MatrixXd::Zero(12, 1);
  a(3, 0) = a(7, 0) = a(11, 0) = size;
  return {Monomials(1, Vector3d::Zero(), Vector3d::Constant(radius)), a};
}

FloatingBody floating(const Shape& shape, const std::vector<Roots>& modes, const Vector3d& gravity) {
  const MassProperties of = mass_properties(shape, 1000);
  return {true, of.mass, of.inertia, gravity, modes, VectorXd::Zero(static_cast<Index>(modes.size())), {}, {}};
}

std::shared_ptr<const SpinCoupling> coupling_of(const Shape& shape, const PolynomialBasis& modes) {
  const Quadrature volume = volume_quadrature(shape);
  return std::make_shared<const SpinCoupling>(
      spin_coupling(volume.points, 1000 * volume.weights, modes.at(volume.points)));
}

SurfaceSamples samples_of(const Shape& shape, const PolynomialBasis& modes, const Grading& cells,
                          const std::vector<Vector3d>& foci) {
  GradedRule rule = graded_rule(shape, foci, cells);
  MatrixXd Phi = modes.at(rule.points);
  const Index m = rule.weights.size();
  return {std::move(rule.points), std::move(rule.weights), std::move(Phi), MatrixXd(3 * m, 0)};
}

BodyState at_rest(const FloatingBody& body, const Vector3d& c, const Vector3d& v) {
  const Index r = body.n_modes();
  return {.c = c,
          .v = v,
          .Q = Eigen::Quaterniond::Identity(),
          .L = Vector3d::Zero(),
          .q = VectorXd::Zero(r),
          .p = VectorXd::Zero(r),
          .s = VectorXd::Zero(body.n_static())};
}

ImpactPlan plan_of(const FloatingBody& body, const Shape& shape, const PolynomialBasis& modes, const BodyState& start,
                   ContactScheme scheme, double step) {
  return {.body = body,
          .shape = shape,
          .geometry = modes,
          .bounds = shape_bounds(shape, modes),
          .start = start,
          .scheme = scheme,
          .step = step};
}

RigidSurface wall(const Vector3d& x, const Vector3d& n) {
  return {HalfSpace{}, 0, {x, shortest_turn(Vector3d::UnitZ(), n)}};
}

}  // namespace mb::testing
