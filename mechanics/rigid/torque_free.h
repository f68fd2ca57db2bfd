// A rigid body turning without torque, in closed form. With I1, I2, I3 the principal moments, I2 between the others,
// and axis 3 the one about which L = I w circulates, so that l = L/|L| keeps l3 > 0:
//
//   I w' = (I w) x w,   q' = 1/2 q (0, w)                                            Euler
//   l = (A cn u, B sn u, C dn u),   u = u0 + lambda t,   w = |L| l / I               Jacobi
//   q = q_L exp(k alpha/2) S(l),   alpha' = |L|/I3 + |L| (1/I1 - 1/I3) A^2 / (1 + C dn u)
//
// S(l) is the shortest turn that takes l to k = e3: since l3 >= 0 it is never singular. alpha'/lambda as a function of
// u has the periods 2K, 4iK' and simple poles of residue +-i where C dn u = -1, at u = +-i (2K' - b) with sn^2(b | m1)
// = (1/I2 - 1/I3) / (1/I1 - 1/I3). Hence alpha/2 = mu t - chi(u), a mean rate and the argument of one theta function
// (elliptic.h). Exact rotation by theta functions: van Zon & Schofield 2007, J. Comput. Phys. 225, 145-164.
//
// Energy and angular momentum keep their values to rounding, whatever t; phases are good to about 4e-16 (1 + |w| |t|),
// |w| at its largest, and to what the motion makes of data off by a rounding, which next to the separatrix |L|^2 = 2 T
// I2 alone is much. Nothing else is a difference of nearly equal numbers: symmetric bodies, near-equal moments and m ->
// 1 lose nothing.
#pragma once

#include "mechanics/rigid/elliptic.h"
#include "mechanics/types.h"

namespace mb {

struct Rotation {
  Eigen::Quaterniond orientation;  // [-] of unit length, x = orientation X takes body axes to the world's
  Vector3d angular_velocity;       // [rad/s] in body axes
};

class TorqueFree {
 public:
  // principal_moments [kg m^2] along the body axes, in any order; omega0_body [rad/s] in body axes, finite. Where the
  // body spins about a principal axis (components of w' at most 1e-150 |w|^2) it does so for ever, about the
  // intermediate one, too. Throws std::invalid_argument where moments are not those of a body
  // (require_principal_moments), the quaternion is off unit length by more than 1e-6 (by less: it is normalised) or the
  // velocity is not finite.
  TorqueFree(const Vector3d& principal_moments, const Eigen::Quaterniond& orientation0, const Vector3d& omega0_body);

  Rotation at(double t) const;       // t [s] of any sign, |w| t below 1e300, else std::invalid_argument
  double max_angular_speed() const;  // [rad/s] least upper bound of |w| over all times, from the two ellipsoids

 private:
  struct Polhode;
  explicit TorqueFree(const Polhode& polhode, const Eigen::Quaterniond& orientation0);

  JacobiFunctions functions_;
  ThetaArgument chi_;
  double lambda_, u0_, mu_;            // [1/s], [-], [rad/s]
  Vector3d l_, omega_;                 // [-] A, B, C; [rad/s] |L| (A/I1, B/I2, C/I3)
  Eigen::Matrix3d to_ordered_;         // [-] from the body's axes to 1, 2, 3 as above
  Eigen::Quaterniond before_, after_;  // [-] orientation = before exp(k (mu t - chi)) S(l) after
};

}  // namespace mb
