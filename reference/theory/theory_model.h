// A body of beam or plate theory in its own modes, and the rigid ball that strikes the middle of its top face. Simply
// supported, with xi = x/L + 1/2 from one end to the other, eta = y/b + 1/2:
//
//   Euler-Bernoulli   E I w'''' + rho A w.. = 0,   A = b h,   I = b h^3/12,   n = 1 ... N
//                     w_n = sqrt(2/(rho A L)) sin(n pi xi),   omega_n = (n pi/L)^2 sqrt(E I/(rho A))
//   Kirchhoff         D lap lap w + rho h w.. = 0,   D = E h^3/(12 (1 - nu^2)),   n = 1 ... N, m = 1 ... M
//                     w_nm = 2/sqrt(rho h L b) sin(n pi xi) sin(m pi eta),
//                     omega_nm = ((n pi/L)^2 + (m pi/b)^2) sqrt(D/(rho h))
//
//   unknowns u = (q, d), d [m] the ball's displacement along z:   M = diag(1, ..., 1, m),   K = diag(omega^2, 0)
//   displacement (-z w_x, -z w_y, w),   eps_xx = -z w_xx,   eps_yy = -z w_yy,   gamma_xy = -2 z w_xy,
//   across the thickness what leaves no stress there: a beam eps_yy = eps_zz = -nu eps_xx, a plate
//   eps_zz = -nu/(1 - nu) (eps_xx + eps_yy)
//
// so that the strains hold the energy that K has. The ball is the rigid mode that no support holds, R = (0, ..., 0,
// m^(-1/2)): damping leaves it alone. Contact is one point of weight 1, in which F = k delta^(3/2) acts; its gap is
// d - w(0, 0). Timoshenko, Young & Weaver 1974, Vibration Problems in Engineering, ch. 5; Leissa 1969, Vibration
// of Plates (NASA SP-160), ch. 4.
#pragma once

#include <memory>

#include "cases/contract/model.h"

namespace mb {

// resolution.cells: {N} or {N, M}, half waves. Throws std::invalid_argument for a solid, another shape than a box, an
// orthotropic material, resolutions that are none of half waves, and where nothing strikes the body. What is refused
// later, as the model has none of it: polynomials and translation.
std::shared_ptr<const FullModel> theory_model(const Scene& scene, const Body& body, const Resolution& resolution);

}  // namespace mb
