#include "mechanics/geometry/polynomial_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {

namespace {

using Eigen::Matrix3d;

constexpr double tolerance = 1e-13;  // [-] residual of the inverse over the extent

// u and du/dxi along each axis.
template <class T>
struct Jet {
  T u, dx, dy, dz;
};

// Nested Horner scheme with derivatives: p <- p s + q, p' <- p' s + p. Two products a monomial, no table of powers.
// T: all components at one point (Coordinate double, a(k) an array), or one component at many (arrays, a(k) double).
template <class T, class Coordinate, class Coefficient>
inline Jet<T> horner(int degree, const Coordinate& x, const Coordinate& y, const Coordinate& z, const Coefficient& a) {
  const T zero = T::Zero();
  Jet<T> p{zero, zero, zero, zero};
  for (int i = degree; i >= 0; --i) {
    T q = zero, q_y = zero, q_z = zero;
    for (int j = degree - i; j >= 0; --j) {
      T s = zero, s_z = zero;
      for (int l = degree - i - j; l >= 0; --l) {
        s_z = s_z * z + s;
        s = s * z + a(monomial_index(i, j, l));
      }
      q_z = q_z * y + s_z;
      q_y = q_y * y + q;
      q = q * y + s;
    }
    p.dz = p.dz * x + q_z;
    p.dy = p.dy * x + q_y;
    p.dx = p.dx * x + p.u;
    p.u = p.u * x + q;
  }
  return p;
}

template <class Matrix4>
inline Jet<Eigen::Array4d> jet(int degree, const Vector3d& xi, const Matrix4& a) {
  return horner<Eigen::Array4d>(degree, xi[0], xi[1], xi[2], [&](Index k) { return a.col(k).array(); });
}

Matrix3d deformation_gradient(const Jet<Eigen::Array4d>& p, const Vector3d& h) {
  Matrix3d F;
  F << p.dx.head<3>() / h[0], p.dy.head<3>() / h[1], p.dz.head<3>() / h[2];
  F.diagonal().array() += 1;
  return F;
}

// Component `component` of u and its derivatives at every point, handed to use(first, n, jet) in blocks of 8.
template <class Matrix4, class Use>
void for_blocks(int degree, const Matrix3Xd& xi, const Matrix4& a, Index component, const Use& use) {
  using Block = Eigen::Array<double, 8, 1>;
  for (Index first = 0; first < xi.cols(); first += Block::SizeAtCompileTime) {
    const Index n = std::min<Index>(Block::SizeAtCompileTime, xi.cols() - first);
    std::array<Block, 3> s = {Block::Zero(), Block::Zero(), Block::Zero()};
    for (Index axis = 0; axis < 3; ++axis) s[static_cast<size_t>(axis)].head(n) = xi.row(axis).segment(first, n);
    use(first, n, horner<Block>(degree, s[0], s[1], s[2], [&](Index k) { return a(component, k); }));
  }
}

int highest_degree(const Eigen::Ref<const Matrix3Xd>& a, int degree) {
  const auto zero = [&](int d) {
    return a.middleCols(n_monomials(d - 1), n_monomials(d) - n_monomials(d - 1)).isZero(0);
  };
  while (degree > 0 && zero(degree)) --degree;
  return degree;
}

Monomials checked(const Monomials& m, const Eigen::Ref<const Matrix3Xd>& a) {
  if (a.cols() != m.size())
    throw std::invalid_argument(fmt::format("polynomial map: {} coefficients for {} monomials", a.cols(), m.size()));
  if (!a.allFinite()) throw std::invalid_argument("polynomial map: a coefficient is not finite");
  return {highest_degree(a, m.degree()), m.centre(), m.half_extents()};
}

// On |xi| <= 1 entry (i, j) of grad(sum_k a_k m_k) is at most that of the result; k from first on.
Matrix3d gradient_bound(const Matrix3Xd& a, const Monomials& m, Index first) {
  Matrix3d bound = Matrix3d::Zero();
  for (Index k = first; k < m.size(); ++k) {
    const auto [i, j, l] = Monomials::exponents(k);
    bound += a.col(k).cwiseAbs() * Vector3d(i, j, l).cwiseQuotient(m.half_extents()).transpose();
  }
  return bound;
}

// Whether the spectral radius of G, entries >= 0, is certainly less than 1: then I - G is a nonsingular M-matrix, which
// is to say that its leading minors are positive (Berman & Plemmons 1994, theorem 6.2.3). Products of entries round one
// another's minors by 1e-15 only, as all of them are less than 1 where the minors are positive.
bool contracts(const Matrix3d& G) {
  constexpr double certain = 1e-12;
  const Matrix3d A = Matrix3d::Identity() - G;
  return A(0, 0) > certain && A.topLeftCorner<2, 2>().determinant() > certain && A.determinant() > certain;
}

// The longest part <= 1 of step d from xi that stays in |xi| <= reach.
double inside(const Vector3d& xi, const Vector3d& d, double reach) {
  double t = 1;
  for (Index a = 0; a < 3; ++a)
    if (std::abs(xi[a] + d[a]) > reach) t = std::min(t, (std::copysign(reach, d[a]) - xi[a]) / d[a]);
  return t;
}

}  // namespace

PolynomialMap::PolynomialMap(const Monomials& monomials, const Eigen::Ref<const Matrix3Xd>& coefficients)
    : monomials_(checked(monomials, coefficients)), a_(4, monomials_.size()) {
  a_.topRows<3>() = coefficients.leftCols(monomials_.size());
  a_.row(3).setZero();
  range_ = reach * monomials_.half_extents();
  for (int d = 0; d <= monomials_.degree(); ++d)
    for (Index k = n_monomials(d - 1); k < n_monomials(d); ++k)
      range_ += std::pow(reach, d) * a_.col(k).head<3>().cwiseAbs();
}

Vector3d PolynomialMap::displacement(const Vector3d& X) const {
  return jet(monomials_.degree(), monomials_.scaled(X), a_).u.head<3>();
}

PolynomialMap::Point PolynomialMap::at(const Vector3d& X) const {
  const Jet<Eigen::Array4d> p = jet(monomials_.degree(), monomials_.scaled(X), a_);
  return {X + p.u.head<3>().matrix(), deformation_gradient(p, monomials_.half_extents())};
}

Matrix3d PolynomialMap::gradient(const Vector3d& X) const { return at(X).F; }

Matrix3Xd PolynomialMap::positions(const Matrix3Xd& X) const {
  const Matrix3Xd xi = monomials_.scaled(X);
  Matrix3Xd x = X;
  for (Index a = 0; a < 3; ++a)
    for_blocks(monomials_.degree(), xi, a_, a,
               [&](Index first, Index n, const auto& p) { x.row(a).segment(first, n) += p.u.head(n).matrix(); });
  return x;
}

Matrix3Xd PolynomialMap::gradients(const Matrix3Xd& X) const {
  const Matrix3Xd xi = monomials_.scaled(X);
  const Vector3d& h = monomials_.half_extents();
  Matrix3Xd F(3, 3 * X.cols());
  for (Index a = 0; a < 3; ++a)
    for_blocks(monomials_.degree(), xi, a_, a, [&](Index first, Index n, const auto& p) {
      for (Index i = 0; i < n; ++i) F.block<1, 3>(a, 3 * (first + i)) << p.dx[i] / h[0], p.dy[i] / h[1], p.dz[i] / h[2];
    });
  for (Index i = 0; i < X.cols(); ++i) F.block<3, 3>(0, 3 * i).diagonal().array() += 1;
  return F;
}

struct PolynomialMap::Iterate {
  Vector3d residual;  // [m] x - c - h xi - u
  Matrix3d F;         // [-]
};

// About the centre: there the residual is free of the rounding of a far-off origin.
PolynomialMap::Iterate PolynomialMap::iterate(const Vector3d& target, const Vector3d& xi) const {
  const Jet<Eigen::Array4d> p = jet(monomials_.degree(), xi, a_);
  const Vector3d& h = monomials_.half_extents();
  return {target - h.cwiseProduct(xi) - p.u.head<3>().matrix(), deformation_gradient(p, h)};
}

std::optional<Vector3d> PolynomialMap::newton(const Vector3d& target, const Vector3d& start, int max_steps) const {
  constexpr double shortest = 1e-4;  // of a Newton step: shorter ones creep along a fold or the region's boundary
  const double small = tolerance * std::max(monomials_.extent(), target.norm());
  Vector3d xi = start;
  Iterate now = iterate(target, xi);
  for (int step = 0; now.F.determinant() > 0; ++step) {
    if (now.residual.norm() <= small) return xi;
    if (step == max_steps) return {};
    const Vector3d d = now.F.partialPivLu().solve(now.residual).cwiseQuotient(monomials_.half_extents());
    if (!d.allFinite()) return {};
    double t = inside(xi, d, reach);
    Iterate next = iterate(target, xi + t * d);
    while (!(next.residual.norm() <= (1 - 1e-4 * t) * now.residual.norm() && next.F.determinant() > 0)) {
      t /= 2;
      if (!(t >= shortest)) return {};
      next = iterate(target, xi + t * d);
    }
    xi += t * d;
    now = next;
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
    starts[static_cast<size_t>(i)] = {iterate(target, xi).residual.norm(), xi};
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

double PolynomialMap::lipschitz_bound() const {
  // |A|_2 <= | |A| |_2, which grows with every entry.
  return gradient_bound(a_.topRows<3>(), monomials_, 1).operatorNorm();
}

Vector3d PolynomialMap::displacement_bound() const { return a_.topRows<3>().cwiseAbs().rowwise().sum(); }

bool PolynomialMap::certainly_invertible() const {
  if (contracts(gradient_bound(a_.topRows<3>(), monomials_, 1))) return true;
  const Matrix3d F0 = gradient(monomials_.centre());
  if (!(F0.determinant() > 0)) return false;
  return contracts(gradient_bound(F0.inverse().lazyProduct(a_.topRows<3>()), monomials_, 4));
}

}  // namespace mb
