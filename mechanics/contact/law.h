// What a point of a surface feels, per reference area, at penetration g = -gap and rate g' = -normal . v:
//
//   p = k_n g max(0, 1 + d g') for g > 0, else 0          (Hunt & Crossley 1975, J. Appl. Mech. 42(2), made linear in
//   g) t = p n - mu p v_t / sqrt(|v_t|^2 + v_eps^2)           (Coulomb, regularised; v_t = v - n (n . v))
//
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
};

// Traction t [Pa] on the body and its derivatives by the point's place and velocity.
struct Traction3 {
  Vector3d t = Vector3d::Zero();
  double pressure = 0;                             // p [Pa] >= 0
  Eigen::Matrix3d by_x = Eigen::Matrix3d::Zero();  // [Pa/m]
  Eigen::Matrix3d by_v = Eigen::Matrix3d::Zero();  // [Pa s/m]
};
Traction3 contact_traction(const PenaltyLaw& law, const Gap& gap, const Vector3d& v);

// The energy per area kept in the layer, k_n g^2 / 2 [J/m^2].
double stored_energy(const PenaltyLaw& law, double gap);

}  // namespace mb
