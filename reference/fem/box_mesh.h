// Meshes of a box: n cells along each axis, whose edges grow in geometric progression,
//
//   h_i = h_1 q^(i - 1),   q = bias^(1/(n - 1)),   sum h_i = edge of the box
//
// and whose corners are then moved at random, x_a += distorted h_a U(-1, 1), h_a the shorter of the two edges beside it
// along axis a; corners on a face stay on it. The sequence of numbers is fixed: a mesh is a function of its resolution.
#pragma once

#include <deal.II/grid/tria.h>

#include "cases/scene/scene.h"

namespace mb::fem {

// [m] places of the n + 1 corners along one axis, the box centred. bias > 0; of one cell it says nothing.
std::vector<double> biased_places(double edge, int n, double bias);

// Throws std::invalid_argument where the resolution states a bias or a distortion out of range (scene.h).
void make_box(dealii::Triangulation<3>& mesh, const Box& box, const Resolution& resolution);

}  // namespace mb::fem
