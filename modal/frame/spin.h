// What rotation and deformation of a floating body do to each other (floating_body.h), in body axes. Of its motion
//
//   T = Omega.J(q) Omega/2 + Omega.C(q) q' + q'.q'/2,      Lambda = J Omega + C q',     pi = q' + C^T Omega
//   J(q) = int rho (|x|^2 1 - x x^T),  x = X + Phi q,      C(q) e_j = int rho (Phi q) x phi_j
//
// follow, with the momenta Lambda = Q^T L and pi as unknowns, equations without a matrix of accelerations:
//
//   Omega = (J - C C^T)^-1 (Lambda - C pi),    q' = pi - C^T Omega,    Q' = Q Omega^
//   pi_i' = Omega.J,i Omega/2 + sum_j Omega.int rho (phi_i x phi_j) q_j' - c_i q_i' - lambda_i q_i
//
// The first two terms are the centrifugal and the gyroscopic force (Coriolis'). Modes are M-orthogonal to rigid motion:
// no other terms couple. Shabana 2020, Dynamics of Multibody Systems, ch. 5, in the mean-axis frame.
//
// J depends on q twice by int rho (phi_i phi_j^T + phi_j phi_i^T): alone that softens the body falsely (Kane, Ryan &
// Banerjee 1987, J. Guid. Control Dyn. 10(2)). The stresses that rotation brings stiffen it as much and more: steadily,
//
//   K u_ab = rho (e_a x_b + e_b x_a), its rigid motion left out,   G_ab = Phi^T G(u_ab) Phi    (stress stiffness)
//
// are the displacement and stiffness of each pair of axes, sum w_ab G_ab q the force where Omega.J Omega/2 = sum w_ab
// int rho x_a x_b; H_ab - G_ab stands for H_ab then: what bends grows shorter, which J counts.
#pragma once

#include <array>

#include "cases/contract/model.h"
#include "modal/frame/floating_body.h"

namespace mb {

// Integrals over the body at rest; pairs of axes: xx yy zz yz zx xy, of one axis with itself the term above once.
struct SpinCoupling {
  MatrixXd A;                 // [kg^1/2 m] 6 x r: int rho (X phi^T + phi X^T)
  std::array<MatrixXd, 6> H;  // [-] r x r: int rho (phi_i phi_j^T + phi_j phi_i^T), less the stiffening
  std::array<MatrixXd, 3> D;  // [-] r x r: int rho phi_i x phi_j along x, y, z
  // Bounds of the stiffening: |sum w_ab q.G_ab q| <= |Omega|^2 s q.Lambda q, |sum w_ab G_ab q| <= |Omega|^2 g
  // |Lambda^1/2 q|, by spectral norms of each G_ab.
  double s = 0, g = 0;  // [s^2], [s]
};

// By quadrature: points [m] 3 x m about the centroid, their masses [kg], Phi there 3 m x r. Throws
// std::invalid_argument where sizes differ.
SpinCoupling spin_coupling(const Matrix3Xd& X, const VectorXd& masses, const MatrixXd& Phi);

// On the mesh of a body without supports, with the stresses that rotation brings or without; Phi n x r. shift [1/s^2]
// as physical_shift's.
SpinCoupling spin_coupling(const FullModel& full, const MatrixXd& Phi, bool stiffened, double shift);

// A state's velocities and what its spin does to the modes, nothing without coupling.
struct Spin {
  Vector3d Omega;    // [rad/s] body axes
  VectorXd rate;     // [m kg^1/2 / s] q', r
  VectorXd carried;  // [m kg^1/2 / s] C^T Omega, r
  VectorXd force;    // [N kg^-1/2] centrifugal and gyroscopic, r
};
Spin spin(const FloatingBody& body, const BodyState& state);  // of a free body

Vector3d angular_velocity(const FloatingBody& body, const BodyState& state);  // [rad/s] world
VectorXd rates(const FloatingBody& body, const BodyState& state);             // q'
// [J] kinetic and strain energy and that of the weight from c = 0 on, without what contact holds.
double mechanical_energy(const FloatingBody& body, const BodyState& state);

}  // namespace mb
