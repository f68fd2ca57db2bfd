#include "reference/fem/contact_surface.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace mb::fem {

namespace {

constexpr double looks_away = -0.1;  // [-] cosine

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

}  // namespace

ContactPoints contact_points(const Discretisation& d, const RigidSurface& surface, double reach) {
  ContactPoints points =
      points_of_faces(d, [&](const dealii::FEFaceValues<3>& face) { return may_touch(face, surface, reach); });
  if (points.w.size() == 0) throw std::invalid_argument("no face of the mesh comes near the obstacle");
  return points;
}

ContactPoints boundary(const Discretisation& d) {
  return points_of_faces(d, [](const dealii::FEFaceValues<3>&) { return true; });
}

}  // namespace mb::fem
