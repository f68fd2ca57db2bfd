// Points of the mesh's boundary that may touch an obstacle, by Gauss's rule on every face:
//
//   x_q = X_q + sum_a N_a(xi_q) u_a,   w_q = |dX/dxi| w,   f_a = sum_q w_q N_a t_q
//
// and the same boundary as points of another body find it. Linear momentum is handed over exactly, since the shape
// functions sum to one.
#pragma once

#include "mechanics/contact/contact.h"
#include "reference/fem/discretisation.h"

namespace mb::fem {

// Every face that somewhere lies within `reach` [m] of the obstacle and looks at it: outward normal . obstacle's normal
// below -0.1. `reach` infinity: of a half-space all that look at it, of others, which a moving body may meet from any
// side, every face of the boundary. Points come in the order of the faces, whatever `reach` is. p + 3 points a
// direction. surface: in the body's axes, as it stands at the first touch. U has discretisation n_dofs columns. Throws
// std::invalid_argument where there is no such face.
ContactPoints contact_points(const Discretisation& d, const RigidSurface& surface, double reach);
ContactPoints boundary(const Discretisation& d);  // every face, for bodies that turn

// The same faces as patches; U has discretisation n_dofs columns.
Facets facets(const Discretisation& d, const RigidSurface& surface, double reach);

}  // namespace mb::fem
