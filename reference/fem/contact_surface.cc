#include "reference/fem/contact_surface.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace mb::fem {

namespace {

constexpr double looks_away = -0.1;  // [-] cosine
constexpr const char* no_face = "no face of the mesh comes near the obstacle";

Vector3d vector(const dealii::Tensor<1, 3>& x) { return {x[0], x[1], x[2]}; }

bool may_touch(const dealii::FEFaceValues<3>& face, const RigidSurface& surface, double reach) {
  if (std::isinf(reach) && !std::holds_alternative<HalfSpace>(surface.shape)) return true;
  for (unsigned q = 0; q < face.n_quadrature_points; ++q) {
    const Gap at = gap(surface, vector(face.quadrature_point(q)));
    if (at.value < reach && at.normal.dot(vector(face.normal_vector(q))) < looks_away) return true;
  }
  return false;
}

using FaceChoice = std::function<bool(const dealii::FEFaceValues<3>&)>;

ContactPoints points_of_faces(const Discretisation& d, const FaceChoice& wanted) {
  const dealii::QGauss<2> rule(d.element.degree + 3);
  dealii::FEFaceValues<3> face(d.mapping, d.element, rule,
                               dealii::update_values | dealii::update_quadrature_points |
                                   dealii::update_normal_vectors | dealii::update_JxW_values);
  std::vector<dealii::types::global_dof_index> ids(d.element.n_dofs_per_cell());
  std::vector<Vector3d> X;
  std::vector<double> w;
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& cell : d.nodes.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (!cell->face(f)->at_boundary()) continue;
      face.reinit(cell, f);
      if (!wanted(face)) continue;
      cell->get_dof_indices(ids);
      for (unsigned q = 0; q < face.n_quadrature_points; ++q) {
        const auto point = static_cast<Index>(X.size());
        X.push_back(vector(face.quadrature_point(q)));
        w.push_back(face.JxW(q));
        for (unsigned a = 0; a < ids.size(); ++a) {
          const double N = face.shape_value(a, q);
          if (std::abs(N) < 1e-14) continue;  // nodes off the face
          for (Index i = 0; i < 3; ++i) entries.emplace_back(3 * point + i, 3 * static_cast<Index>(ids[a]) + i, N);
        }
      }
    }
  const auto n = static_cast<Index>(X.size());
  ContactPoints points{Matrix3Xd(3, n), Eigen::Map<const VectorXd>(w.data(), n), SparseMatrix(3 * n, d.n_dofs())};
  for (Index i = 0; i < n; ++i) points.X.col(i) = X[static_cast<size_t>(i)];
  points.U.setFromTriplets(entries.begin(), entries.end());
  return points;
}

// Of a cell's nodes those on its face f, by ascending coordinates along the two axes across it, the first running
// fastest.
std::vector<unsigned> nodes_of_face(const dealii::FE_Q<3>& element, unsigned f) {
  const auto& places = element.get_unit_support_points();
  const unsigned across = f / 2, first = across == 0 ? 1 : 0, second = across == 2 ? 1 : 2;
  std::vector<unsigned> nodes;
  for (unsigned a = 0; a < places.size(); ++a)
    if (std::abs(places[a][across] - (f % 2)) < 1e-9) nodes.push_back(a);
  std::ranges::sort(nodes, {}, [&](unsigned a) {
    return std::pair(std::round(1e9 * places[a][second]), std::round(1e9 * places[a][first]));
  });
  return nodes;
}

// S_1 x S_2 along the element's axes: outward on faces whose first axis, second axis and normal are right-handed.
bool is_right_handed(unsigned f) {
  const bool even = f / 2 != 1;  // y x z = x, x y -> z; x z -> -y
  return even == (f % 2 == 1);
}

VectorXd places_along_edge(const dealii::FE_Q<3>& element) {
  const auto nodes = nodes_of_face(element, 4);
  VectorXd places(element.degree + 1);
  for (Index i = 0; i < places.size(); ++i)
    places[i] = element.get_unit_support_points()[nodes[static_cast<size_t>(i)]][0];
  return places;
}

}  // namespace

Facets facets(const Discretisation& d, const RigidSurface& surface, double reach) {
  dealii::FEFaceValues<3> face(d.mapping, d.element, dealii::QGauss<2>(d.element.degree + 3),
                               dealii::update_quadrature_points | dealii::update_normal_vectors);
  const Index n = static_cast<Index>(d.element.degree) + 1;
  std::vector<dealii::types::global_dof_index> ids(d.element.n_dofs_per_cell());
  std::vector<int> patches, place(static_cast<size_t>(d.n_nodes()), -1);
  std::vector<Index> used;
  for (const auto& cell : d.nodes.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (!cell->face(f)->at_boundary()) continue;
      face.reinit(cell, f);
      if (!may_touch(face, surface, reach)) continue;
      cell->get_dof_indices(ids);
      const auto nodes = nodes_of_face(d.element, f);
      const bool turned = !is_right_handed(f);
      for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) {
          const auto id = ids[nodes[static_cast<size_t>(turned ? j + n * i : i + n * j)]];
          if (place[id] < 0) place[id] = static_cast<int>(used.size()), used.push_back(static_cast<Index>(id));
          patches.push_back(place[id]);
        }
    }
  if (patches.empty()) throw std::invalid_argument(no_face);
  const auto k = static_cast<Index>(used.size());
  Facets all{places_along_edge(d.element),
             Eigen::Map<const Eigen::MatrixXi>(patches.data(), n * n, std::ssize(patches) / (n * n)),
             d.node_positions()(Eigen::all, used), SparseMatrix(3 * k, d.n_dofs())};
  std::vector<Eigen::Triplet<double>> entries;
  for (Index a = 0; a < k; ++a)
    for (Index i = 0; i < 3; ++i) entries.emplace_back(3 * a + i, 3 * used[static_cast<size_t>(a)] + i, 1.0);
  all.U.setFromTriplets(entries.begin(), entries.end());
  return all;
}

ContactPoints contact_points(const Discretisation& d, const RigidSurface& surface, double reach) {
  ContactPoints points =
      points_of_faces(d, [&](const dealii::FEFaceValues<3>& face) { return may_touch(face, surface, reach); });
  if (points.w.size() == 0) throw std::invalid_argument(no_face);
  return points;
}

ContactPoints boundary(const Discretisation& d) {
  return points_of_faces(d, [](const dealii::FEFaceValues<3>&) { return true; });
}

}  // namespace mb::fem
