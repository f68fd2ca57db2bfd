// One body in its floating frame (Buckens): the frame moves so that the deformation carries no momentum,
//
//   x(X, t) = c + Q (X + Phi(X) q + Psi(X) s),    m c'' = sum f + m g,   L' = sum (x - c) x f,   L = Q J Q^T Omega
//   q_i'' + c_i q_i' + lambda_i q_i = sum Phi_i^T Q^T f
//   K_s (s + beta s') = sum Psi^T Q^T f      static shapes, massless
//
// Elastic modes are M-orthogonal to rigid motion, so that to first order in q nothing couples but through contact:
// centrifugal and gyroscopic terms are left out unless the body has a coupling (spin.h). A body that supports hold has
// no rigid part: c and Q stand still, and what rigid motion its supports leave is among its modes (lambda = 0).
#pragma once

#include <memory>
#include <vector>

#include "mechanics/contact/law.h"
#include "mechanics/geometry/polynomial_basis.h"
#include "mechanics/geometry/pose.h"
#include "mechanics/system/oscillator.h"

namespace mb {

// Samples of the analytic surface, each with its share of the area, and the shapes there.
struct SurfaceSamples {
  Matrix3Xd X;   // [m] 3 x m, body frame
  VectorXd w;    // [m^2] m, > 0
  MatrixXd Phi;  // [kg^-1/2] 3 m x r: xyz of sample 0, of sample 1, ...
  MatrixXd Psi;  // [m] 3 m x n_s
};

// The surface of another body, as samples meet it: the shape, carried by its modes. What its static shapes do is known
// where the samples lie at the first touch. Made by partner_surface (modal/contact/surface_polynomials.h).
struct PartnerSurface {
  size_t body;                    // its place among the bodies that move together
  Shape shape;                    // convex
  PolynomialBasis geometry;       // [kg^-1/2] its modes, in the box of its monomials about the first touch
  Matrix3Xd feet;                 // [m] 3 x m, its frame: of the samples at the first touch
  MatrixXd Psi;                   // [m] n_s x 3 m, its frame: its static shapes there
  double radius;                  // [m] of the shape about its centre
  VectorXd largest_q, largest_s;  // r, n_s: bounds of each mode's and static shape's displacement
};

struct SampleTables;  // modal/contact/sample_tables.h
class SampleTree;     // modal/contact/sample_tree.h
struct SpinCoupling;  // spin.h
struct FrameLoads;    // frame_loads.h

struct SampledContact {
  SurfaceSamples samples;
  RigidSurface surface;  // in the world; not looked at where there is a partner
  PenaltyLaw law;
  std::shared_ptr<const SampleTables> tables = nullptr;     // of these samples; none: each run makes its own
  std::shared_ptr<const PartnerSurface> partner = nullptr;  // none: an obstacle
  std::shared_ptr<const SampleTree> tree = nullptr;         // where there is a partner; none: each run makes its own
};

struct FloatingBody {
  bool free;                  // whether it has a rigid part
  double mass;                // [kg]
  Eigen::Matrix3d inertia;    // J [kg m^2] about the centroid, body frame
  Vector3d gravity;           // [m/s^2] world
  std::vector<Roots> modes;   // r
  VectorXd weight;            // [N kg^-1/2] r: modal force of gravity, of a body that is held; 0 of a free one
  MatrixXd static_stiffness;  // K_s [J] n_s x n_s, SPD
  std::vector<SampledContact> contacts;
  double static_damping = 0; /* beta [s] >= 0, of Rayleigh's damping */
  // Of a free body: how its spin strains it and its modes turn it. None: its rotation is a rigid body's.
  std::shared_ptr<const SpinCoupling> coupling = nullptr;
  std::shared_ptr<const FrameLoads> loads = nullptr;  // on a free body that nothing touches

  Index n_modes() const { return static_cast<Index>(modes.size()); }
  Index n_static() const { return static_stiffness.rows(); }
};

struct BodyState {
  Vector3d c, v;         // [m], [m/s] of the frame, world
  Eigen::Quaterniond Q;  // of unit length
  Vector3d L;            // [kg m^2/s] angular momentum about c, world
  VectorXd q, p;         // [m kg^1/2], [m kg^1/2 / s] r: modes and their rates; with a coupling momenta, q' + C^T Omega
  VectorXd s;            // [-] n_s
};

inline bool is_finite(const BodyState& state) {
  return state.c.allFinite() && state.v.allFinite() && state.Q.coeffs().allFinite() && state.L.allFinite() &&
         state.q.allFinite() && state.p.allFinite() && state.s.allFinite();
}

}  // namespace mb
