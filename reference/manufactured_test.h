// For tests by manufactured solutions on a box: a field that vanishes on all faces, with its derivatives,
//
//   u = sum_k a_k sin(k_x pi x/l_x) sin(k_y pi y/l_y) sin(k_z pi z/l_z),   x from the lower corner
//
// and a rule that integrates over every cell of a mesh.
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cases/scene/scene.h"
#include "mechanics/geometry/gauss.h"

namespace mb::testing {

struct Field {
  Vector3d u;
  Eigen::Matrix3d gradient;
  std::array<Eigen::Matrix3d, 3> second;  // of component j
};
using Waves = std::vector<std::pair<Vector3d, Vector3d>>;  // a [m], k

inline Field field(const Vector3d& size, const Waves& waves, const Vector3d& X) {
  using Eigen::Matrix3d;
  Field f{Vector3d::Zero(), Matrix3d::Zero(), {Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero()}};
  for (const auto& [a, k] : waves) {
    const Vector3d q = pi * k.cwiseQuotient(size);
    Vector3d s, c;
    for (int i = 0; i < 3; ++i)
      s[i] = std::sin(q[i] * (X[i] + size[i] / 2)), c[i] = std::cos(q[i] * (X[i] + size[i] / 2));
    const double product = s.prod();
    const Vector3d first(q[0] * c[0] * s[1] * s[2], q[1] * s[0] * c[1] * s[2], q[2] * s[0] * s[1] * c[2]);
    Matrix3d second;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        second(i, j) = i == j ? -q[i] * q[i] * product : q[i] * q[j] * c[i] * c[j] * s[3 - i - j];
    f.u += a * product;
    f.gradient += a * first.transpose();
    for (int j = 0; j < 3; ++j) f.second[static_cast<size_t>(j)] += a[j] * second;
  }
  return f;
}

// Gauss's rule in every cell, p + 2 points a direction.
inline Quadrature rule_of(const Vector3d& size, const Resolution& mesh) {
  const Rule rule = gauss_legendre(mesh.degree + 2);
  const Index n = rule.x.size();
  std::array<VectorXd, 3> x, w;
  for (size_t d = 0; d < 3; ++d) {
    const auto i = static_cast<Index>(d);
    const double h = size[i] / mesh.cells[d];
    x[d].resize(n * mesh.cells[d]), w[d].resize(n * mesh.cells[d]);
    for (Index cell = 0; cell < mesh.cells[d]; ++cell)
      for (Index q = 0; q < n; ++q)
        x[d][n * cell + q] = -size[i] / 2 + h * (static_cast<double>(cell) + rule.x[q]),
                        w[d][n * cell + q] = h * rule.w[q];
  }
  Quadrature all{Matrix3Xd(3, x[0].size() * x[1].size() * x[2].size()),
                 VectorXd(x[0].size() * x[1].size() * x[2].size())};
  Index at = 0;
  for (Index i = 0; i < x[0].size(); ++i)
    for (Index j = 0; j < x[1].size(); ++j)
      for (Index k = 0; k < x[2].size(); ++k, ++at) {
        all.points.col(at) = Vector3d(x[0][i], x[1][j], x[2][k]);
        all.weights[at] = w[0][i] * w[1][j] * w[2][k];
      }
  return all;
}

}  // namespace mb::testing
