#include "reference/fem/evaluation.h"

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <fmt/format.h>

#include <functional>
#include <limits>
#include <stdexcept>

namespace mb::fem {

namespace {

using Cell = dealii::DoFHandler<3>::active_cell_iterator;
using Point = dealii::Point<3>;

struct Location {
  Point xi;
  double outside;  // distance of xi from the unit cell, largest coordinate; 0 inside
};

Location locate(const Discretisation& d, const Cell& cell, const Point& x) {
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  if (!cell->bounding_box().point_inside(x, 3)) return {{}, nowhere};  // slack: curved faces bulge
  try {
    const Point xi = d.mapping.transform_real_to_unit_cell(cell, x);
    double outside = 0;
    for (unsigned k = 0; k < 3; ++k) outside = std::max({outside, -xi[k], xi[k] - 1});
    return {xi, outside > 1e-10 ? outside : 0};  // Newton's inversion of the mapping is good to about 1e-12
  } catch (const dealii::Mapping<3>::ExcTransformationFailed&) {
    return {{}, nowhere};
  }
}

struct Located {
  Cell cell;
  Point xi;
};
Located nearest_cell(const Discretisation& d, const Point& x) {
  Located best;
  double outside = std::numeric_limits<double>::infinity();
  for (const Cell& cell : d.nodes.active_cell_iterators()) {
    const Location here = locate(d, cell, x);
    if (here.outside < outside) {
      best = {cell, here.xi};
      outside = here.outside;
    }
    if (outside == 0) break;
  }
  // The faces of the coarsest linear meshes lie below the true surface: five blocks of a disc by 0.7 of a cell, seven
  // of a ball by 1.8. Two cells away is outside.
  if (!(outside < 2)) throw std::invalid_argument(fmt::format("point ({}, {}, {}) lies in no cell", x[0], x[1], x[2]));
  return best;
}

// Calls entry(point, node, N, gradient of N) for every point and every node of its cell.
using Entry = std::function<void(Index point, Index node, double N, const dealii::Tensor<1, 3>& gradient)>;
void for_each_entry(const Discretisation& d, const Matrix3Xd& points, const Entry& entry) {
  std::vector<dealii::types::global_dof_index> ids(d.element.n_dofs_per_cell());
  for (Index p = 0; p < points.cols(); ++p) {
    const Located at = nearest_cell(d, Point(points(0, p), points(1, p), points(2, p)));
    dealii::FEValues<3> values(d.mapping, d.element, dealii::Quadrature<3>(at.xi),
                               dealii::update_values | dealii::update_gradients);
    values.reinit(at.cell);
    at.cell->get_dof_indices(ids);
    for (unsigned a = 0; a < ids.size(); ++a)
      entry(p, static_cast<Index>(ids[a]), values.shape_value(a, 0), values.shape_grad(a, 0));
  }
}

SparseMatrix from_triplets(Index rows, Index cols, const std::vector<Eigen::Triplet<double>>& entries) {
  SparseMatrix A(rows, cols);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

}  // namespace

SparseMatrix displacement_at(const Discretisation& d, const Matrix3Xd& points) {
  std::vector<Eigen::Triplet<double>> entries;
  for_each_entry(d, points, [&](Index p, Index a, double N, const auto&) {
    for (Index i = 0; i < 3; ++i) entries.emplace_back(3 * p + i, 3 * a + i, N);
  });
  return from_triplets(3 * points.cols(), d.n_dofs(), entries);
}

SparseMatrix strain_at(const Discretisation& d, const Matrix3Xd& points) {
  std::vector<Eigen::Triplet<double>> entries;
  for_each_entry(d, points, [&](Index p, Index a, double, const auto& g) {
    for (Index i = 0; i < 3; ++i) {
      const Index j = (i + 1) % 3, k = (i + 2) % 3;  // shear strain between j and k stands in row 3 + i
      entries.emplace_back(6 * p + i, 3 * a + i, g[static_cast<unsigned>(i)]);
      entries.emplace_back(6 * p + 3 + i, 3 * a + j, g[static_cast<unsigned>(k)]);
      entries.emplace_back(6 * p + 3 + i, 3 * a + k, g[static_cast<unsigned>(j)]);
    }
  });
  return from_triplets(6 * points.cols(), d.n_dofs(), entries);
}

}  // namespace mb::fem
