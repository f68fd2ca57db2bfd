#include "mechanics/geometry/polynomial_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {

namespace {

using Eigen::Matrix3d;

// u and du/dxi along each axis.
template <class T>
struct Jet {
  T u, dx, dy, dz;
};

// Nested Horner scheme with derivatives: p <- p s + q, p' <- p' s + p. Two products a monomial, no table of powers.
// T: all components at one point (Coordinate double, a(k) an array), or one component at many (arrays, a(k) double).
enum class Order { values, derivatives };  // which to compute; derivatives that are not stay 0
template <Order order, class T, class Coordinate, class Coefficient>
inline Jet<T> horner(int degree, const Coordinate& x, const Coordinate& y, const Coordinate& z, const Coefficient& a) {
  constexpr bool derivatives = order == Order::derivatives;
  const T zero = T::Zero();
  Jet<T> p{zero, zero, zero, zero};
  for (int i = degree; i >= 0; --i) {
    T q = zero, q_y = zero, q_z = zero;
    for (int j = degree - i; j >= 0; --j) {
      T s = zero, s_z = zero;
      for (int l = degree - i - j; l >= 0; --l) {
        if constexpr (derivatives) s_z = s_z * z + s;
        s = s * z + a(monomial_index(i, j, l));
      }
      if constexpr (derivatives) {
        q_z = q_z * y + s_z;
        q_y = q_y * y + q;
      }
      q = q * y + s;
    }
    if constexpr (derivatives) {
      p.dz = p.dz * x + q_z;
      p.dy = p.dy * x + q_y;
      p.dx = p.dx * x + p.u;
    }
    p.u = p.u * x + q;
  }
  return p;
}

template <Order order, class Matrix4>
inline Jet<Eigen::Array4d> jet(int degree, const Vector3d& xi, const Matrix4& a) {
  return horner<order, Eigen::Array4d>(degree, xi[0], xi[1], xi[2], [&](Index k) { return a.col(k).array(); });
}

Matrix3d deformation_gradient(const Jet<Eigen::Array4d>& p, const Vector3d& h) {
  Matrix3d F;
  F << p.dx.head<3>() / h[0], p.dy.head<3>() / h[1], p.dz.head<3>() / h[2];
  F.diagonal().array() += 1;
  return F;
}

// Component `component` of u (and its derivatives) at every point, handed to use(first, n, jet) in blocks of 16.
template <Order order, class Matrix4, class Use>
void for_blocks(int degree, const Matrix3Xd& xi, const Matrix4& a, Index component, const Use& use) {
  using Block = Eigen::Array<double, 16, 1>;
  for (Index first = 0; first < xi.cols(); first += Block::SizeAtCompileTime) {
    const Index n = std::min<Index>(Block::SizeAtCompileTime, xi.cols() - first);
    std::array<Block, 3> s = {Block::Zero(), Block::Zero(), Block::Zero()};
    for (Index axis = 0; axis < 3; ++axis) s[static_cast<size_t>(axis)].head(n) = xi.row(axis).segment(first, n);
    use(first, n, horner<order, Block>(degree, s[0], s[1], s[2], [&](Index k) { return a(component, k); }));
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
  return jet<Order::values>(monomials_.degree(), monomials_.scaled(X), a_).u.head<3>();
}

PolynomialMap::Point PolynomialMap::at(const Vector3d& X) const {
  const Jet<Eigen::Array4d> p = jet<Order::derivatives>(monomials_.degree(), monomials_.scaled(X), a_);
  return {X + p.u.head<3>().matrix(), deformation_gradient(p, monomials_.half_extents())};
}

Matrix3d PolynomialMap::gradient(const Vector3d& X) const { return at(X).F; }

Matrix3Xd PolynomialMap::positions(const Matrix3Xd& X) const {
  const Matrix3Xd xi = monomials_.scaled(X);
  Matrix3Xd x = X;
  for (Index a = 0; a < 3; ++a)
    for_blocks<Order::values>(monomials_.degree(), xi, a_, a, [&](Index first, Index n, const auto& p) {
      x.row(a).segment(first, n) += p.u.head(n).matrix();
    });
  return x;
}

Matrix3Xd PolynomialMap::gradients(const Matrix3Xd& X) const { return points(X).F; }

PolynomialMap::Points PolynomialMap::points(const Matrix3Xd& X) const {
  const Matrix3Xd xi = monomials_.scaled(X);
  const Vector3d& h = monomials_.half_extents();
  Points at{X, Matrix3Xd(3, 3 * X.cols())};
  for (Index a = 0; a < 3; ++a)
    for_blocks<Order::derivatives>(monomials_.degree(), xi, a_, a, [&](Index first, Index n, const auto& p) {
      at.x.row(a).segment(first, n) += p.u.head(n).matrix();
      for (Index i = 0; i < n; ++i)
        at.F.block<1, 3>(a, 3 * (first + i)) << p.dx[i] / h[0], p.dy[i] / h[1], p.dz[i] / h[2];
    });
  for (Index i = 0; i < X.cols(); ++i) at.F.block<3, 3>(0, 3 * i).diagonal().array() += 1;
  return at;
}

PolynomialMap::Point PolynomialMap::about_centre(const Vector3d& xi) const {
  const Jet<Eigen::Array4d> p = jet<Order::derivatives>(monomials_.degree(), xi, a_);
  const Vector3d& h = monomials_.half_extents();
  return {h.cwiseProduct(xi) + p.u.head<3>().matrix(), deformation_gradient(p, h)};
}

double PolynomialMap::lipschitz_bound() const {
  // |A|_2 <= | |A| |_2, which grows with every entry. Scaled, as its square may overflow.
  const Matrix3d G = gradient_bound(a_.topRows<3>(), monomials_, 1);
  const double largest = G.maxCoeff();
  return largest > 0 && std::isfinite(largest) ? largest * (G / largest).operatorNorm() : largest;
}

Vector3d PolynomialMap::displacement_bound() const { return a_.topRows<3>().cwiseAbs().rowwise().sum(); }

bool PolynomialMap::certainly_invertible() const {
  if (contracts(gradient_bound(a_.topRows<3>(), monomials_, 1))) return true;
  const Matrix3d F0 = gradient(monomials_.centre());
  // Relative to Hadamard's bound: the sign of a smaller determinant is rounding's.
  if (!(F0.determinant() > 1e-12 * F0.colwise().norm().prod())) return false;
  return contracts(gradient_bound(F0.inverse().lazyProduct(a_.topRows<3>()), monomials_, 4));
}

}  // namespace mb
