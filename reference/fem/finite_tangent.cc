// FiniteStrain's tangent, cell by cell: products of n x q matrices, no allocation in the loop.
#include <algorithm>
#include <stdexcept>

#include "reference/fem/finite_strain.h"

namespace mb::fem {

namespace {

using Eigen::Matrix3d;
using Blocks = std::array<MatrixXd, 3>;

// Row `row` of column `column` among the values of K.
int place_in(const SparseMatrix& K, Index row, Index column) {
  const int* first = K.innerIndexPtr() + K.outerIndexPtr()[column];
  const int* last = K.innerIndexPtr() + K.outerIndexPtr()[column + 1];
  const int* at = std::lower_bound(first, last, static_cast<int>(row));
  if (at == last || *at != row) throw std::logic_error("finite strain: K lacks an entry of a cell");
  return static_cast<int>(at - K.innerIndexPtr());
}

}  // namespace

struct FiniteStrain::Scratch {
  Scratch(Index n, Index n_q)
      : u(3, n), H(3, 3 * n_q), D(3 * n, 3 * n), block(n, n), scaled(n, n_q), coefficients(n_q, 4), spread(n_q, 6) {
    for (auto* field : {&g, &h})
      for (MatrixXd& component : *field) component.resize(n, n_q);
  }
  MatrixXd u, H, D, block, scaled;
  Blocks g, h;            // n x q each
  MatrixXd coefficients;  // q x 4: of the four products below
  MatrixXd spread;        // q x 6: mu F F^T, upper triangle
  MatrixXd condensed;

  // block += x_i diag(c_0) x_j^T + x_j diag(c_1) x_i^T, c_0 = coefficients.col(first) and c_1 the next one
  void add_products(const Blocks& x, size_t i, size_t j, Index first) {
    scaled = x[i] * coefficients.col(first).asDiagonal();
    if (i == j) {
      scaled += x[i] * coefficients.col(first + 1).asDiagonal();
      block.noalias() += scaled * x[i].transpose();
      return;
    }
    block.noalias() += scaled * x[j].transpose();
    scaled = x[j] * coefficients.col(first + 1).asDiagonal();
    block.noalias() += scaled * x[i].transpose();
  }
};

void FiniteStrain::condense(Cell& cell, const Eigen::SparseMatrix<double, Eigen::RowMajor>& T,
                            const SparseMatrix& K) const {
  std::vector<Index> unknowns;
  bool plain = true;
  const auto rows = [&](auto&& visit) {
    for (size_t a = 0; a < cell.nodes.size(); ++a)
      for (Index i = 0; i < 3; ++i)
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(T, 3 * cell.nodes[a] + i); it; ++it)
          visit(3 * static_cast<Index>(a) + i, it.col(), it.value());
  };
  std::vector<int> entries(3 * cell.nodes.size(), 0);
  rows([&](Index row, Index column, double value) {
    unknowns.push_back(column);
    plain = plain && value == 1 && ++entries[static_cast<size_t>(row)] == 1;
  });
  std::ranges::sort(unknowns);
  unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
  const auto local = [&](Index column) { return std::ranges::lower_bound(unknowns, column) - unknowns.begin(); };
  Condensed& to = cell.to;
  to.m = static_cast<Index>(unknowns.size());
  if (plain)
    to.place.assign(entries.size(), -1);
  else
    to.T.setZero(static_cast<Index>(entries.size()), to.m);
  rows([&](Index row, Index column, double value) {
    if (plain)
      to.place[static_cast<size_t>(row)] = static_cast<int>(local(column));
    else
      to.T(row, local(column)) = value;
  });
  for (const Index column : unknowns)
    for (const Index row : unknowns) to.values.push_back(place_in(K, row, column));
}

// g, h, coefficients and spread at the cell's points; false where it inverts.
bool FiniteStrain::evaluate(const Cell& cell, const VectorXd& nodal, double by_u, double viscous, Scratch& s) const {
  const Index n = static_cast<Index>(cell.nodes.size()), n_q = cell.w.size();
  for (Index a = 0; a < n; ++a) s.u.col(a) = nodal.segment<3>(3 * cell.nodes[static_cast<size_t>(a)]);
  s.H.noalias() = s.u * cell.gradients;
  for (Index q = 0; q < n_q; ++q) {
    Matrix3d F = Matrix3d::Identity();
    for (Index k = 0; k < 3; ++k) F.col(k) += s.H.col(k * n_q + q);
    const auto now = deformation(F);
    if (!now) return false;
    s.coefficients.row(q) << by_u * c_.lambda, by_u * (c_.mu - c_.lambda * now->log_J), viscous * c_.lambda,
        viscous * c_.mu;
    s.coefficients.row(q) *= cell.w[q];
    const auto dN = [&](Index k) { return cell.gradients.col(k * n_q + q); };
    for (Index i = 0; i < 3; ++i) {
      const auto at = static_cast<size_t>(i);
      s.g[at].col(q) = now->G(0, i) * dN(0) + now->G(1, i) * dN(1) + now->G(2, i) * dN(2);
      if (viscous != 0) s.h[at].col(q) = F(i, 0) * dN(0) + F(i, 1) * dN(1) + F(i, 2) * dN(2);
    }
    if (viscous == 0) continue;
    const Matrix3d b = cell.w[q] * viscous * c_.mu * F * F.transpose();
    s.spread.row(q) << b(0, 0), b(0, 1), b(0, 2), b(1, 1), b(1, 2), b(2, 2);
  }
  return true;
}

bool FiniteStrain::tangent_of(const Cell& cell, const VectorXd& nodal, double by_u, double by_v, Scratch& s) const {
  const Index n = static_cast<Index>(cell.nodes.size()), n_q = cell.w.size();
  const double viscous = by_v * beta_;
  if (!evaluate(cell, nodal, by_u, viscous, s)) return false;
  Index pair = 0;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = i; j < 3; ++j, ++pair) {
      if (i == j)
        s.block = (by_u * c_.mu) * cell.laplacian;
      else
        s.block.setZero();
      s.add_products(s.g, i, j, 0);
      if (viscous != 0) {
        s.add_products(s.h, i, j, 2);
        for (Index k = 0; k < 3; ++k) {
          const auto dN = cell.gradients.middleCols(k * n_q, n_q);
          s.scaled = dN * s.spread.col(pair).asDiagonal();
          s.block.noalias() += s.scaled * dN.transpose();
        }
      }
      const auto I = Eigen::seqN(static_cast<Index>(i), n, 3), J = Eigen::seqN(static_cast<Index>(j), n, 3);
      s.D(I, J) = s.block;
      if (i != j) s.D(J, I) = s.block.transpose();
    }
  return true;
}

void FiniteStrain::add(const Cell& cell, Scratch& s, SparseMatrix& A) {
  const auto& [place, T, values, m] = cell.to;
  double* const a = A.valuePtr();
  if (place.empty()) {
    s.condensed.noalias() = T.transpose() * (s.D * T);
    for (Index k = 0; k < m * m; ++k) a[values[static_cast<size_t>(k)]] += s.condensed.data()[k];
    return;
  }
  for (Index c = 0; c < s.D.cols(); ++c) {
    const Index column = place[static_cast<size_t>(c)];
    if (column < 0) continue;
    for (Index r = 0; r < s.D.rows(); ++r)
      if (const Index row = place[static_cast<size_t>(r)]; row >= 0)
        a[values[static_cast<size_t>(column * m + row)]] += s.D(r, c);
  }
}

bool FiniteStrain::add_tangent(const VectorXd& u, double by_u, double by_v, SparseMatrix& A) const {
  const VectorXd nodal = at_nodes(u);
  Scratch s(static_cast<Index>(cells_.front().nodes.size()), cells_.front().w.size());
  for (const Cell& cell : cells_) {
    if (!tangent_of(cell, nodal, by_u, by_v, s)) return false;
    add(cell, s, A);
  }
  return true;
}

}  // namespace mb::fem
