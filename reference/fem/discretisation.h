// Hexahedra of degree p on a shape: mesh, isoparametric mapping with exact curved boundary, scalar Lagrange nodes.
// A cylinder's cells {0, layers}: one block across the disc, the square in it, its sides bent to the circle from degree
// 2 on (degree 1: the inscribed prism). Degree of freedom 3 a + i is component i of node a. Included only within
// reference/fem (deal.II's door).
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

#include "cases/scene/scene.h"

namespace mb::fem {

// Not movable: deal.II's objects refer to each other.
struct Discretisation {
  // Throws std::invalid_argument for a resolution out of range (scene.h).
  Discretisation(const Shape& shape, const Resolution& resolution);

  Shape shape;
  std::vector<std::string> faces;  // boundary id -> name
  dealii::Triangulation<3> mesh;
  dealii::MappingQ<3> mapping;
  dealii::FE_Q<3> element;
  dealii::DoFHandler<3> nodes;

  Index n_nodes() const { return static_cast<Index>(nodes.n_dofs()); }
  Index n_dofs() const { return 3 * n_nodes(); }
  Matrix3Xd node_positions() const;  // [m] 3 x n_nodes
  int boundary_id(const std::string& face) const;
};

}  // namespace mb::fem
