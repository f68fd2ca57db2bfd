#include "modal/polygons/polygons.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace mb {

namespace {

// Of the edge between two vertices, always seen from the one with the lower number.
Vector3d nearest_on_edge(const Matrix3Xd& vertices, int i, int j, const Vector3d& x) {
  if (i > j) std::swap(i, j);
  const Vector3d origin = vertices.col(i), along = vertices.col(j) - origin;
  return origin + std::clamp((x - origin).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
}

Vector3d face_vector(const TriangleMesh& mesh, Index i) {
  const Eigen::Vector3i t = mesh.triangles.col(i);
  const Vector3d a = mesh.vertices.col(t[0]);
  return (mesh.vertices.col(t[1]) - a).cross(mesh.vertices.col(t[2]) - a);
}

double angle(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

void require_valid(const TriangleMesh& mesh) {
  if (mesh.triangles.cols() < 4) throw std::invalid_argument("polygons: fewer than 4 triangles enclose nothing");
  if (!mesh.vertices.allFinite()) throw std::invalid_argument("polygons: a vertex is not finite");
  if (mesh.triangles.minCoeff() < 0 || mesh.triangles.maxCoeff() >= mesh.vertices.cols())
    throw std::invalid_argument("polygons: a triangle names a vertex that is not there");
  for (Index i = 0; i < mesh.triangles.cols(); ++i)
    if (!(face_vector(mesh, i).norm() > 0))
      throw std::invalid_argument(fmt::format("polygons: triangle {} has no area", i));
}

}  // namespace

Polygons::Polygons(TriangleMesh mesh) : mesh_(std::move(mesh)) {
  require_valid(mesh_);
  extent_ = mesh_.vertices.cwiseAbs().maxCoeff();
  add_normals();
}

void Polygons::add_normals() {
  std::map<std::pair<int, int>, Vector3d> of_edge;  // by directed edge: the normal of the triangle it belongs to
  Matrix3Xd of_vertex = Matrix3Xd::Zero(3, mesh_.vertices.cols());
  for (Index i = 0; i < size(); ++i) {
    const Vector3d n = face_vector(mesh_, i).normalized();
    for (int k = 0; k < 3; ++k) {
      const int a = mesh_.triangles(k, i), b = mesh_.triangles((k + 1) % 3, i), c = mesh_.triangles((k + 2) % 3, i);
      if (!of_edge.emplace(std::pair(a, b), n).second)
        throw std::invalid_argument(fmt::format("polygons: edge {}-{} has two triangles on one side", a, b));
      of_vertex.col(a) +=
          angle(mesh_.vertices.col(b) - mesh_.vertices.col(a), mesh_.vertices.col(c) - mesh_.vertices.col(a)) * n;
    }
  }
  normals_.resize(static_cast<size_t>(size()));
  for (Index i = 0; i < size(); ++i) {
    auto& normals = normals_[static_cast<size_t>(i)].of_feature;
    normals[0] = face_vector(mesh_, i).normalized();
    for (int k = 0; k < 3; ++k) {
      const int a = mesh_.triangles(k, i), b = mesh_.triangles((k + 1) % 3, i);
      const auto other = of_edge.find({b, a});
      if (other == of_edge.end()) throw std::invalid_argument(fmt::format("polygons: not closed at edge {}-{}", a, b));
      normals[static_cast<size_t>(1 + k)] = normals[0] + other->second;
      normals[static_cast<size_t>(4 + k)] = of_vertex.col(a);
    }
  }
}

long Polygons::bytes() const {
  return static_cast<long>(sizeof(double)) * mesh_.vertices.size() +
         static_cast<long>(sizeof(int)) * mesh_.triangles.size() + static_cast<long>(sizeof(Normals) * normals_.size());
}

NearestOnTriangle Polygons::nearest(Index i, const Vector3d& x) const {
  const int* corner = mesh_.triangles.data() + 3 * i;
  const Vector3d a = mesh_.vertices.col(corner[0]), b = mesh_.vertices.col(corner[1]),
                 c = mesh_.vertices.col(corner[2]);
  const auto at = [&](const Vector3d& point, int feature) {
    return NearestOnTriangle{(x - point).squaredNorm(), point, feature};
  };
  const auto on_edge = [&](int k) {
    return at(nearest_on_edge(mesh_.vertices, corner[k], corner[(k + 1) % 3], x), 1 + k);
  };
  const Vector3d ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const double d1 = ab.dot(ax), d2 = ac.dot(ax), d3 = ab.dot(bx), d4 = ac.dot(bx), d5 = ab.dot(cx), d6 = ac.dot(cx);
  if (d1 <= 0 && d2 <= 0) return at(a, 4);
  if (d3 >= 0 && d4 <= d3) return at(b, 5);
  const double by_c = d1 * d4 - d3 * d2;
  if (by_c <= 0 && d1 >= 0 && d3 <= 0) return on_edge(0);
  if (d6 >= 0 && d5 <= d6) return at(c, 6);
  const double by_b = d5 * d2 - d1 * d6;
  if (by_b <= 0 && d2 >= 0 && d6 <= 0) return on_edge(2);
  const double by_a = d3 * d6 - d5 * d4;
  if (by_a <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return on_edge(1);
  const double sum = by_a + by_b + by_c;
  return at(a + by_b / sum * ab + by_c / sum * ac, 0);
}

double Polygons::signed_distance(Index i, const Vector3d& x, const NearestOnTriangle& nearest) const {
  const Vector3d& n = normals_[static_cast<size_t>(i)].of_feature[static_cast<size_t>(nearest.feature)];
  const double distance = std::sqrt(nearest.squared_distance);
  return (x - nearest.point).dot(n) < 0 ? -distance : distance;
}

}  // namespace mb
