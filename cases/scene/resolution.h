// The size of a mesh before it is made. With m = degree * splits, a layer of the cylinder's disc (one square, four
// blocks around it) has (m + 1)^2 + 4 m^2 nodes; the ball (one cube, six blocks around it) has
// (m + 1)^3 + m (6 m^2 + 2), shells of the cube's surface nodes; superquadrics likewise. A cylinder of 0 splits is one
// block across: (p + 1)^2 nodes a layer, p the degree. Each grading about one point of a plane surface halves the cells
// whose centres lie in half a ball of 1.1 of their diameters d,
//
//   2/3 pi (1.1 d)^3 / (volume of a cell),   for cubes 14.5,
//
// of which n_dofs counts half as much again, for obtuse corners and balance, p^3 nodes for each new cell: an upper
// bound for one touch, without hanging nodes.
//
// A body of beam or plate theory has no mesh but half waves, and one more unknown: what strikes it.
#pragma once

#include "cases/scene/scene.h"
#include "cases/scene/section.h"

namespace mb {

// Before supports; 0 without a mesh.
double n_dofs(const Shape& shape, const Resolution& resolution, Theory theory = Theory::solid);
// At most: all but the rigid modes that a body without supports has.
double n_elastic(const Shape& shape, const Resolution& resolution, Theory theory = Theory::solid);
// 3, 2, 1 for box, cylinder, sphere and superquadrics. 1 for beams, 2 for plates.
std::size_t n_cell_entries(const Shape& shape, Theory theory = Theory::solid);
const char* kind_name(const Shape& shape);  // "box", ..., "tapered superquadric"

inline constexpr double most_dofs = 2e6;        // [-] assembled K and M of more do not fit one machine
inline constexpr double most_half_waves = 1e4;  // [-] of beams and plates: they are seen at every point
inline constexpr double grading_reach = 1.1;    // [-] diameters of a cell: nearer to a touch it is halved

inline const Range degree_range{1, 4};
inline const Range cells_range{1, 1024};
// A cylinder may have 0 edge splits: one block across the disc. Other shapes are checked by check_mesh.
inline const Range any_cells_range{0, 1024};

// Whether such a mesh can be made: number of entries, powers of two, number of degrees of freedom. Records what is
// wrong.
bool check_mesh(const Shape& shape, const Resolution& resolution, const Position& where, Findings& findings,
                Theory theory = Theory::solid);

// A table with `degree` and `cells`. The shape is nothing where it was wrong: then only ranges are checked.
std::optional<Resolution> read_resolution(Section section, const std::optional<Shape>& shape,
                                          Theory theory = Theory::solid);

}  // namespace mb
