#include "reference/fem/grading.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/scene/resolution.h"

namespace mb::fem {

namespace {

using Mesh = dealii::Triangulation<3>;
using Point = dealii::Point<3>;

constexpr double flattest = 0.01;  // [-] least to largest Jacobian of a cell; coarse balls come down to 0.03

std::vector<Point> conforming_places(const dealii::Mapping<3>& surface, const dealii::DoFHandler<3>& nodes,
                                     const HangingNodes& hanging) {
  std::vector<Point> x(nodes.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(surface, nodes, x);
  for (const auto& line : hanging.get_lines()) {
    Point place;
    for (const auto& [master, c] : line.entries) place += c * x[master];
    x[line.index] = place;
  }
  return x;
}

}  // namespace

void refine_near(Mesh& mesh, const std::vector<Vector3d>& foci) {
  for (const auto& cell : mesh.active_cell_iterators()) {
    const Point centre = cell->center();
    const double radius = grading_reach * cell->diameter();
    if (std::any_of(foci.begin(), foci.end(),
                    [&](const Vector3d& x) { return centre.distance(Point(x[0], x[1], x[2])) < radius; }))
      cell->set_refine_flag();
  }
  mesh.execute_coarsening_and_refinement();
}

HangingNodes hanging_nodes(const dealii::DoFHandler<3>& nodes) {
  HangingNodes hanging;
  dealii::DoFTools::make_hanging_node_constraints(nodes, hanging);
  hanging.close();
  return hanging;
}

void map_conforming(const dealii::DoFHandler<3>& nodes, const HangingNodes& hanging,
                    dealii::MappingQCache<3>& mapping) {
  const dealii::MappingQ<3> surface(mapping.get_degree());
  const Mesh& mesh = nodes.get_triangulation();
  if (hanging.n_constraints() == 0) return mapping.initialize(surface, mesh);
  const std::vector<Point> x = conforming_places(surface, nodes, hanging);
  const auto& unit = nodes.get_fe().get_unit_support_points();
  mapping.initialize(mesh, [&](const Mesh::cell_iterator& cell) {
    std::vector<Point> places(unit.size());
    if (!cell->is_active()) {  // asked for, though never used
      for (size_t a = 0; a < unit.size(); ++a) places[a] = surface.transform_unit_to_real_cell(cell, unit[a]);
      return places;
    }
    std::vector<dealii::types::global_dof_index> ids(unit.size());
    dealii::DoFHandler<3>::active_cell_iterator(&mesh, cell->level(), cell->index(), &nodes)->get_dof_indices(ids);
    std::transform(ids.begin(), ids.end(), places.begin(), [&](auto a) { return x[a]; });
    return places;
  });
}

void require_sound_cells(const dealii::DoFHandler<3>& nodes, const dealii::Mapping<3>& mapping) {
  // The points that the matrices and the lumped mass take, corners among them.
  const unsigned p = nodes.get_fe().degree;
  std::vector<Point> points = dealii::QGaussLobatto<3>(p + 1).get_points();
  const std::vector<Point> inner = dealii::QGauss<3>(p + 1).get_points();
  points.insert(points.end(), inner.begin(), inner.end());
  dealii::FEValues<3> values(mapping, nodes.get_fe(), dealii::Quadrature<3>(points), dealii::update_jacobians);
  for (const auto& cell : nodes.active_cell_iterators()) {
    values.reinit(cell);
    double least = values.jacobian(0).determinant(), largest = least;
    for (unsigned q = 1; q < points.size(); ++q) {
      least = std::min(least, values.jacobian(q).determinant());
      largest = std::max(largest, values.jacobian(q).determinant());
    }
    if (least > flattest * largest) continue;
    const Point x = cell->center();
    throw std::invalid_argument(
        fmt::format("grading flattens or turns the cell at ({:.4g}, {:.4g}, {:.4g}) m: Jacobian from {:.2g} to {:.2g}",
                    x[0], x[1], x[2], least, largest));
  }
}

}  // namespace mb::fem
