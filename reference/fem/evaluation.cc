#include "reference/fem/evaluation.h"

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace mb::fem {

namespace {

using Cell = dealii::DoFHandler<3>::active_cell_iterator;
using Point = dealii::Point<3>;

struct Location {
  Point xi;
  double outside;  // distance of xi from the unit cell, largest coordinate; 0 inside
};

Location locate(const Discretisation& d, const Cell& cell, const Point& x) {
  try {
    const Point xi = d.mapping.transform_real_to_unit_cell(cell, x);
    double outside = 0;
    for (unsigned k = 0; k < 3; ++k) outside = std::max({outside, -xi[k], xi[k] - 1});
    return {xi, outside > 1e-10 ? outside : 0};  // Newton's inversion of the mapping is good to about 1e-12
  } catch (const dealii::Mapping<3>::ExcTransformationFailed&) {
    return {{}, std::numeric_limits<double>::infinity()};
  }
}

// No other cell holds the point, or comes nearer to it: it lies well within the faces that others share, ten times as
// far as it is outside of those that none does. Inversions for far cells fail, and deal.II traces each failure's calls.
bool is_this_alone(const Cell& cell, const Location& here) {
  const double margin = 10 * here.outside + 1e-6;
  for (unsigned k = 0; k < 3; ++k) {
    if (here.xi[k] < margin && !cell->face(2 * k)->at_boundary()) return false;
    if (here.xi[k] > 1 - margin && !cell->face(2 * k + 1)->at_boundary()) return false;
  }
  return here.outside < 0.05;
}

struct Located {
  Cell cell;
  Point xi;
};

// Finds the cell of a point, the nearest one where it lies in none, among those whose box of vertices is near it.
class Cells {
 public:
  explicit Cells(const Discretisation& d) : d_(d) {
    for (const Cell& cell : d.nodes.active_cell_iterators()) {
      const auto [low, high] = cell->bounding_box().get_boundary_points();
      cells_.push_back({cell, low, high});
    }
    near_.reserve(cells_.size());
  }

  Located nearest(const Point& x) {
    near_.clear();
    for (size_t i = 0; i < cells_.size(); ++i)
      if (const double away = cells_[i].away(x); away < farthest) near_.push_back({away, i});
    std::ranges::sort(near_);
    double outside = std::numeric_limits<double>::infinity();
    std::pair<size_t, Point> best;
    for (const auto& [away, i] : near_) {
      if (away > bulge + 2 * outside) break;
      const Location here = locate(d_, cells_[i].cell, x);
      if (here.outside < outside || (here.outside == outside && i < best.first)) {
        best = {i, here.xi};
        outside = here.outside;
        if (is_this_alone(cells_[i].cell, here)) break;
      }
    }
    // The faces of the coarsest linear meshes lie below the true surface: five blocks of a disc by 0.7 of a cell, seven
    // of a ball by 1.8. Two cells away is outside.
    if (!(outside < 2))
      throw std::invalid_argument(fmt::format("point ({}, {}, {}) lies in no cell", x[0], x[1], x[2]));
    return {cells_[best.first].cell, best.second};
  }

 private:
  static constexpr double farthest = 3;  // [-] of the box's size
  static constexpr double bulge = 1.5;   // [-] how far curved faces leave the box of their vertices, at most

  struct Boxed {
    Cell cell;
    Point low, high;
    // Of the box's own size, the largest coordinate; 0 within it.
    double away(const Point& x) const {
      double far = 0;
      for (unsigned k = 0; k < 3; ++k)
        far = std::max(far, std::max(low[k] - x[k], x[k] - high[k]) / (high[k] - low[k]));
      return far;
    }
  };

  const Discretisation& d_;
  std::vector<Boxed> cells_;
  std::vector<std::pair<double, size_t>> near_;
};

// Calls entry(point, node, N, gradient of N) for every point and every node of its cell, cell by cell.
using Entry = std::function<void(Index point, Index node, double N, const dealii::Tensor<1, 3>& gradient)>;
constexpr size_t most_at_once = 256;  // points, of 12 kB each with elements of degree 4
void for_each_entry(const Discretisation& d, const Matrix3Xd& points, const Entry& entry) {
  std::map<Cell, std::pair<std::vector<Index>, std::vector<Point>>> met;
  Cells cells(d);
  for (Index p = 0; p < points.cols(); ++p) {
    const Located at = cells.nearest(Point(points(0, p), points(1, p), points(2, p)));
    met[at.cell].first.push_back(p);
    met[at.cell].second.push_back(at.xi);
  }
  std::vector<dealii::types::global_dof_index> ids(d.element.n_dofs_per_cell());
  for (const auto& [cell, here] : met) {
    cell->get_dof_indices(ids);
    for (size_t first = 0; first < here.first.size(); first += most_at_once) {
      const size_t end = std::min(here.first.size(), first + most_at_once);
      const std::vector<Point> xi(here.second.begin() + first, here.second.begin() + end);
      dealii::FEValues<3> values(d.mapping, d.element, dealii::Quadrature<3>(xi),
                                 dealii::update_values | dealii::update_gradients);
      values.reinit(cell);
      for (unsigned q = 0; q < xi.size(); ++q)
        for (unsigned a = 0; a < ids.size(); ++a)
          entry(here.first[first + q], static_cast<Index>(ids[a]), values.shape_value(a, q), values.shape_grad(a, q));
    }
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

VectorXd nodal_loads(const Discretisation& d, const Matrix3Xd& points, const Matrix3Xd& forces) {
  VectorXd load = VectorXd::Zero(d.n_dofs());
  for_each_entry(d, points,
                 [&](Index p, Index a, double N, const auto&) { load.segment<3>(3 * a) += N * forces.col(p); });
  return load;
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
