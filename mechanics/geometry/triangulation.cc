#include "mechanics/geometry/triangulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "mechanics/geometry/surface_patches.h"

namespace mb {

namespace {

constexpr double coincident = 1e-12;  // by the extent: far above the rounding of two maps of one point

// The grids of all patches, one after the other, n + 1 by n + 1 points each.
Matrix3Xd grid_points(const std::vector<SurfacePatch>& patches, int n) {
  Matrix3Xd x(3, static_cast<Index>(patches.size()) * (n + 1) * (n + 1));
  Index at = 0;
  for (const SurfacePatch& patch : patches)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j, ++at) x.col(at) = patch.at(static_cast<double>(i) / n, static_cast<double>(j) / n).x;
  return x;
}

// For every grid point the first one of the same place. Only points on the patches' edges can have others there; along
// a direction in general position those lie next to each other.
std::vector<Index> first_of_place(const Matrix3Xd& x, int n, double tolerance) {
  const Vector3d direction = Vector3d(1, 0.7548776662466927, 0.5698402909980532).normalized();  // irrational ratios
  std::vector<Index> first(x.cols());
  std::iota(first.begin(), first.end(), Index{0});
  std::vector<std::pair<double, Index>> rim;
  for (Index k = 0; k < x.cols(); ++k) {
    const Index i = k / (n + 1) % (n + 1), j = k % (n + 1);
    if (i == 0 || i == n || j == 0 || j == n) rim.emplace_back(direction.dot(x.col(k)), k);
  }
  std::sort(rim.begin(), rim.end());
  for (std::size_t a = 0; a < rim.size(); ++a)
    for (std::size_t b = a + 1; b < rim.size() && rim[b].first - rim[a].first <= tolerance; ++b) {
      const auto [low, high] = std::minmax(rim[a].second, rim[b].second);
      if ((x.col(low) - x.col(high)).norm() <= tolerance) first[high] = std::min(first[high], low);
    }
  return first;
}

struct Numbering {
  std::vector<int> vertex;  // of every grid point
  Matrix3Xd vertices;
};

Numbering numbered(const Matrix3Xd& x, const std::vector<Index>& first) {
  Numbering numbering{std::vector<int>(x.cols()), Matrix3Xd(3, x.cols())};
  int n_v = 0;
  for (Index k = 0; k < x.cols(); ++k) {
    if (first[k] == k) numbering.vertices.col(n_v) = x.col(k);
    numbering.vertex[k] = first[k] == k ? n_v++ : numbering.vertex[first[k]];
  }
  numbering.vertices.conservativeResize(3, n_v);
  return numbering;
}

Eigen::Matrix3Xi triangles_of(const Numbering& numbering, Index n_patches, int n) {
  const Matrix3Xd& x = numbering.vertices;
  Eigen::Matrix3Xi triangles(3, 2 * n_patches * n * n);
  Index at = 0;
  for (Index patch = 0; patch < n_patches; ++patch)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j, at += 2) {
        const Index k = (patch * (n + 1) + i) * (n + 1) + j;
        const int a = numbering.vertex[k], b = numbering.vertex[k + n + 1];
        const int c = numbering.vertex[k + n + 2], d = numbering.vertex[k + 1];
        if ((x.col(a) - x.col(c)).squaredNorm() <= (x.col(b) - x.col(d)).squaredNorm()) {
          triangles.col(at) << a, b, c;
          triangles.col(at + 1) << a, c, d;
        } else {
          triangles.col(at) << a, b, d;
          triangles.col(at + 1) << b, c, d;
        }
      }
  return triangles;
}

// Every directed edge once, and its opposite too.
bool is_closed(const Eigen::Matrix3Xi& triangles) {
  std::vector<std::pair<int, int>> edges, opposite;
  for (Index t = 0; t < triangles.cols(); ++t)
    for (int i = 0; i < 3; ++i) {
      edges.emplace_back(triangles(i, t), triangles((i + 1) % 3, t));
      opposite.emplace_back(edges.back().second, edges.back().first);
    }
  std::sort(edges.begin(), edges.end());
  std::sort(opposite.begin(), opposite.end());
  return edges == opposite && std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

VectorXd vertex_areas(const Matrix3Xd& x, const Eigen::Matrix3Xi& triangles) {
  VectorXd area = VectorXd::Zero(x.cols());
  for (Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Vector3i v = triangles.col(t);
    const Vector3d a = x.col(v[1]) - x.col(v[0]), b = x.col(v[2]) - x.col(v[0]);
    for (const int i : v) area[i] += a.cross(b).stableNorm() / 6;
  }
  return area;
}

}  // namespace

TriangleMesh triangulate(const Shape& shape, int n) {
  const std::vector<SurfacePatch> patches = surface_patches(shape);
  const Index n_patches = static_cast<Index>(patches.size());
  if (n < 1 || n > max_triangles || 2 * n_patches * n * n > max_triangles)
    throw std::invalid_argument(fmt::format(
        "triangulate: {} pieces of each edge of {} patches, range 1 to {} triangles", n, n_patches, max_triangles));
  const Matrix3Xd x = grid_points(patches, n);
  const Numbering numbering = numbered(x, first_of_place(x, n, coincident * extent(shape)));
  const Eigen::Matrix3Xi triangles = triangles_of(numbering, n_patches, n);
  const Index euler = numbering.vertices.cols() - triangles.cols() / 2;  // a closed mesh has 3/2 n_t edges
  if (euler != 2 || !is_closed(triangles))
    throw std::invalid_argument(
        fmt::format("triangulate: vertices of a shape of {} m are not told apart: too flat", extent(shape)));
  return {numbering.vertices, triangles, vertex_areas(numbering.vertices, triangles)};
}

}  // namespace mb
