// What a mode looks like and what a shaken base would make of it.
//
//   degree         least p with |Q_p^T M phi|^2 >= 0.9 phi^T M phi,   Q_p an M-orthonormal basis of the polynomials
//   participation  (phi^T M r_d)^2 / (r_d^T M r_d),                   r_d the unit translation along d = x, y, z
//
// Participation is the effective modal mass as a share of all mass. Over all modes of a free body it adds up to 1, of
// which the rigid modes have everything; of a supported one to what its free degrees of freedom carry. Clough & Penzien
// 1993, Dynamics of Structures, sect. 26.
#pragma once

#include <vector>

#include "cases/contract/model.h"
#include "cases/contract/modes.h"

namespace mb {

inline constexpr int most_degree = 4;           // of the polynomials that are tried
inline constexpr double degree_share = 0.9;     // [-] of a mode's M norm squared that a polynomial must hold
inline constexpr int beyond = most_degree + 1;  // the degree of modes that no polynomial tried holds

// Of each mode the least degree in [0, most_degree] of a displacement field, polynomial in x, y, z and admitted by the
// supports, that holds its share; else beyond. Phi: n x k.
std::vector<int> polynomial_degrees(const FullModel& full, const MatrixXd& Phi);

// k x 3, all >= 0. Phi: n x k; Mr: n x 3 [kg], T^T M r_d at the free degrees of freedom, for mode shapes of unit modal
// mass; mass [kg] > 0 of the whole body. Throws std::invalid_argument where sizes do not fit or the mass is none.
MatrixXd participation(const MatrixXd& Phi, const MatrixXd& Mr, double mass);

// T^T M r_d by quadrature [kg], n x 3, for bodies whose matrices know their free degrees of freedom alone: points and
// weights in the body's exact shape, scaled to the mesh's volume. density [kg/m^3]. Of a body with six rigid modes the
// part in their span: its translations are rigid motions, and elastic modes have none of them.
MatrixXd translated_mass(const FullModel& full, const Quadrature& volume, double density);

}  // namespace mb
