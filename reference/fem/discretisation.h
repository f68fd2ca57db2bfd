// Hexahedra of degree p on a shape: mesh, isoparametric mapping with exact curved boundary, scalar Lagrange nodes.
// A cylinder's cells {0, layers}: one block across the disc, the square in it, its sides bent to the circle from degree
// 2 on (degree 1: the inscribed prism). Degree of freedom 3 a + i is component i of node a, hanging ones (grading.h)
// included. Included only within reference/fem (deal.II's door).
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

#include "cases/scene/scene.h"
#include "reference/fem/grading.h"

namespace mb::fem {

// Not movable: deal.II's objects refer to each other.
struct Discretisation {
  // foci [m]: points in the body or on its surface to which a graded mesh is graded, at least one; otherwise not looked
  // at. Throws std::invalid_argument for a resolution out of range (scene.h), foci elsewhere, and graded meshes which
  // become larger than most_dofs (cases/scene/resolution.h) or flatten a cell (grading.h).
  Discretisation(const Shape& shape, const Resolution& resolution, const std::vector<Vector3d>& foci = {});

  Shape shape;
  std::vector<std::string> faces;  // boundary id -> name
  dealii::Triangulation<3> mesh;
  dealii::MappingQCache<3> mapping;
  dealii::FE_Q<3> element;
  dealii::DoFHandler<3> nodes;
  HangingNodes hanging;

  Index n_nodes() const { return static_cast<Index>(nodes.n_dofs()); }
  Index n_dofs() const { return 3 * n_nodes(); }
  Matrix3Xd node_positions() const;  // [m] 3 x n_nodes
  int boundary_id(const std::string& face) const;
};

}  // namespace mb::fem
