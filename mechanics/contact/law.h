// What a point of a surface feels, per reference area, at penetration g = -gap and rate g' = -normal . v:
//
//   p = k_n g max(0, 1 + d g') for g > 0, else 0          (Hunt & Crossley 1975, J. Appl. Mech. 42(2), made linear in
//   g) t = p n - mu p v_t / sqrt(|v_t|^2 + v_eps^2)           (Coulomb, regularised; v_t = v - n (n . v))
//
// e = 1: a layer on the surface. e = 3/2: Hertz's law of two bodies, lumped in one point of weight 1, k_n in [N/m^1.5].
// Continuous at touch, never adhesive. Stick is creep: v_t / v_eps = tan where the load asks for less than mu p.
#pragma once

#include <optional>

#include "mechanics/contact/rigid_surface.h"

namespace mb {

struct Friction {
  double coefficient; /* mu [-] in [0, 10] */
  double slip_speed;  /* v_eps [m/s] > 0 */
};

struct PenaltyLaw {
  double stiffness;                  // k_n [Pa/m] > 0
  double damping = 0;                // d [s/m] >= 0
  std::optional<Friction> friction;  // none: frictionless
  double exponent = 1;               // e [-] in [1, 2]
};

// Traction t [Pa] on the body and its derivatives by the point's place and velocity.
struct Traction3 {
  Vector3d t = Vector3d::Zero();
  double pressure = 0;                             // p [Pa] >= 0
  Eigen::Matrix3d by_x = Eigen::Matrix3d::Zero();  // [Pa/m]
  Eigen::Matrix3d by_v = Eigen::Matrix3d::Zero();  // [Pa s/m]
};
Traction3 contact_traction(const PenaltyLaw& law, const Gap& gap, const Vector3d& v);

// Without damping and friction, per area: p [Pa] at a gap, its derivative by the gap [Pa/m] (both 0 outside), and the
// energy kept, k_n g^(e+1)/(e+1) [J/m^2].
struct Layer {
  double pressure, by_gap;
};
Layer layer(const PenaltyLaw& law, double gap);
double stored_energy(const PenaltyLaw& law, double gap);

}  // namespace mb
