#include "mechanics/geometry/polynomial.h"

#include <fmt/format.h>

#include <stdexcept>

namespace mb {

namespace {

constexpr Index max_size = n_monomials(max_polynomial_degree);

// m_k = xi_axis m_below: the recurrence by which values and gradients are made.
struct Factors {
  std::array<int, 3> exponents;
  size_t axis;
  Index below;
};

constexpr std::array<Factors, max_size> graded_order() {
  std::array<Factors, max_size> order{};
  for (int total = 0; total <= max_polynomial_degree; ++total)
    for (int i = 0; i <= total; ++i)
      for (int j = 0; i + j <= total; ++j) {
        const int l = total - i - j;
        Factors& f = order[static_cast<size_t>(monomial_index(i, j, l))];
        f.exponents = {i, j, l};
        f.axis = i > 0 ? 0 : j > 0 ? 1 : 2;
        if (total > 0)
          f.below = monomial_index(i - (f.axis == 0 ? 1 : 0), j - (f.axis == 1 ? 1 : 0), l - (f.axis == 2 ? 1 : 0));
      }
  return order;
}

constexpr auto factors = graded_order();

}  // namespace

Monomials::Monomials(int degree, const Vector3d& centre, const Vector3d& half_extents)
    : degree_(degree), centre_(centre), half_extents_(half_extents) {
  if (degree < 0 || degree > max_polynomial_degree)
    throw std::invalid_argument(fmt::format("monomials: degree {} is not in 0 ... {}", degree, max_polynomial_degree));
  if (!centre.allFinite()) throw std::invalid_argument("monomials: the centre is not finite");
  if (!(half_extents.minCoeff() > 0) || !half_extents.allFinite())
    throw std::invalid_argument(fmt::format("monomials: half extents {}, {}, {} m are not all positive",
                                            half_extents[0], half_extents[1], half_extents[2]));
}

std::array<int, 3> Monomials::exponents(Index k) {
  if (k < 0 || k >= max_size) throw std::invalid_argument(fmt::format("monomials: there is no number {}", k));
  return factors[static_cast<size_t>(k)].exponents;
}

Matrix3Xd Monomials::scaled(const Matrix3Xd& X) const {
  return half_extents_.cwiseInverse().asDiagonal() * (X.colwise() - centre_);
}

MatrixXd Monomials::values(const Matrix3Xd& X) const {
  const MatrixXd xi = scaled(X).transpose();
  MatrixXd m(X.cols(), size());
  m.col(0).setOnes();
  for (Index k = 1; k < size(); ++k) {
    const Factors& f = factors[static_cast<size_t>(k)];
    m.col(k) = xi.col(static_cast<Index>(f.axis)).cwiseProduct(m.col(f.below));
  }
  return m;
}

std::array<MatrixXd, 3> Monomials::gradients(const Matrix3Xd& X) const {
  const MatrixXd xi = scaled(X).transpose(), m = values(X);
  std::array<MatrixXd, 3> along;
  for (size_t a = 0; a < 3; ++a) {
    MatrixXd& d = along[a];
    d.resize(X.cols(), size());
    d.col(0).setZero();
    for (Index k = 1; k < size(); ++k) {
      const Factors& f = factors[static_cast<size_t>(k)];
      d.col(k) = xi.col(static_cast<Index>(f.axis)).cwiseProduct(d.col(f.below));
      if (f.axis == a) d.col(k) += m.col(f.below) / half_extents_[static_cast<Index>(a)];
    }
  }
  return along;
}

Monomials monomials_about(const Matrix3Xd& X, int degree) {
  if (X.cols() == 0 || !X.allFinite())
    throw std::invalid_argument(X.cols() == 0 ? "monomials: no points" : "monomials: a point is not finite");
  const Vector3d low = X.rowwise().minCoeff();
  Vector3d half = 0.5 * (X.rowwise().maxCoeff() - low);
  const Vector3d centre = low + half;
  const double largest = half.maxCoeff();
  if (!(largest > 0)) throw std::invalid_argument("monomials: no two points differ, nothing to scale by");
  half = (half.array() < 1e-12 * largest).select(Vector3d::Constant(largest), half);
  return {degree, centre, half};
}

}  // namespace mb
