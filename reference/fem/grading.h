// Meshes graded towards points: a cell with
//
//   |x - centre of the cell| < 1.1 times its largest diagonal       for a focus x
//
// is halved in all directions, `graded` times over (neighbours differ by one halving at most). Seen from a focus cells
// are about a third of their distance wide, down to the smallest: 14 to 18 of a regular grid are halved each time, up
// to 21 of a ball.
//
// Where a cell meets halved ones, nodes of theirs hang on it: their values follow from its own,
//
//   u_hanging = sum_m c_m u_m,   and so do their places,   x_hanging = sum_m c_m x_m,
//
// so that neighbours share every point of their faces, on curved ones, too: the mesh has no gaps, and whatever is
// linear is in the space. All other nodes of a curved face lie on the exact surface, these to the coarser cell's error.
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

#include "mechanics/types.h"

namespace mb::fem {

using HangingNodes = dealii::AffineConstraints<double>;

// Halves the cells near a focus [m] once; new vertices follow the mesh's manifolds.
void refine_near(dealii::Triangulation<3>& mesh, const std::vector<Vector3d>& foci);

// Of the scalar Lagrange nodes, masters never hanging themselves; empty for a mesh without halved neighbours.
HangingNodes hanging_nodes(const dealii::DoFHandler<3>& nodes);

// The isoparametric mapping through the places above, of the nodes' degree.
void map_conforming(const dealii::DoFHandler<3>& nodes, const HangingNodes& hanging, dealii::MappingQCache<3>& mapping);

// Throws std::invalid_argument where a cell's Jacobian is not positive or varies more than a hundredfold: in the
// corners of a cylinder of one block, where the circle leaves no angle, halved cells are ever flatter.
void require_sound_cells(const dealii::DoFHandler<3>& nodes, const dealii::Mapping<3>& mapping);

}  // namespace mb::fem
