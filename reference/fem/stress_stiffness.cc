#include "reference/fem/stress_stiffness.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <stdexcept>

namespace mb::fem {

namespace {

using Eigen::Matrix3d;

// Of H = grad u.
Matrix3d stress(const Matrix6d& D, const Matrix3d& H) {
  const Eigen::Vector<double, 6> eps{H(0, 0),           H(1, 1),           H(2, 2),
                                     H(1, 2) + H(2, 1), H(0, 2) + H(2, 0), H(0, 1) + H(1, 0)};
  const Eigen::Vector<double, 6> s = D * eps;
  Matrix3d sigma;
  sigma << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
  return sigma;
}

}  // namespace

SparseMatrix stress_stiffness(const Discretisation& d, const Material& material, const VectorXd& u) {
  if (u.size() != d.n_dofs()) throw std::invalid_argument("stress stiffness: displacements of all nodes are wanted");
  const Matrix6d D = elasticity_matrix(material);
  const dealii::QGauss<3> gauss(d.element.degree + 1);
  dealii::FEValues<3> values(d.mapping, d.element, gauss,
                             dealii::update_gradients | dealii::update_JxW_values | dealii::update_quadrature_points);
  const Index n = d.element.n_dofs_per_cell();
  std::vector<dealii::types::global_dof_index> ids(static_cast<size_t>(n));
  std::vector<Eigen::Triplet<double>> entries;
  MatrixXd dN(3, n), own(3, n), G(n, n);
  for (const auto& cell : d.nodes.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(ids);
    for (Index a = 0; a < n; ++a) own.col(a) = u.segment<3>(3 * static_cast<Index>(ids[static_cast<size_t>(a)]));
    G.setZero();
    for (unsigned q = 0; q < gauss.size(); ++q) {
      for (Index a = 0; a < n; ++a)
        for (unsigned k = 0; k < 3; ++k) dN(k, a) = values.shape_grad(static_cast<unsigned>(a), q)[k];
      const Matrix3d H = own * dN.transpose();
      const auto& x = values.quadrature_point(q);
      const double factor = stiffness_factor(material, {x[0], x[1], x[2]});
      G.noalias() += dN.transpose() * (values.JxW(q) * factor * stress(D, H)) * dN;
    }
    for (Index b = 0; b < n; ++b)
      for (Index a = 0; a < n; ++a)
        for (int i = 0; i < 3; ++i)
          entries.emplace_back(static_cast<int>(3 * ids[static_cast<size_t>(a)]) + i,
                               static_cast<int>(3 * ids[static_cast<size_t>(b)]) + i, G(a, b));
  }
  SparseMatrix all(d.n_dofs(), d.n_dofs());
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

}  // namespace mb::fem
