// A scene of one body at another slenderness: section kept, length changed along the longest extent a, and time with
// it,
//
//   l' = r w,   x_a' = x_a l'/l,   t' = t T'/T,    w the larger extent of the section, T the lowest elastic period
//
// so that a load acts as many periods of the body as it did. Places of discs and probes move along, radii stay; cells
// keep their length.
#pragma once

#include "cases/scene/scene.h"

namespace mb {

double slenderness(const Shape& shape);  // [-] l/w >= 1; throws std::invalid_argument for all but boxes and cylinders

// ratio [-] > 0. Its histories and times are those of the scene as yet. At least as many cells along as across. Throws
// std::invalid_argument for more than one body, contacts, other shapes than boxes and cylinders, and theories of beams.
Scene stretched(const Scene& scene, double ratio);

// A box with the ratio of its longest to its shortest extent: every extent longer than the shortest one is changed in
// proportion, places with it, radii of discs where two are changed; the mesh keeps its number of cells. aspect [-]
// >= 1. Throws std::invalid_argument for a cube, and as stretched() does.
Scene proportioned(const Scene& scene, double aspect);

// factor > 0. Throws std::invalid_argument for expressions.
History slowed(const History& history, double factor);
Scene slowed(Scene scene, double factor);  // histories of loads and drives, duration, samples

}  // namespace mb
