// The bodies of a scene in their modes and floating frames: where they may touch is sampled on their exact surfaces,
// graded towards each first touch. In scenes without contact, of free bodies of finite kinematics alone, loads move
// them (modal/frame/frame_loads.h).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cases/contract/model.h"
#include "cases/contract/modes.h"
#include "cases/contract/touchdown.h"
#include "mechanics/geometry/polynomial_regression.h"
#include "modal/contact/modal_bounds.h"
#include "modal/frame/floating_body.h"

namespace mb {

// What does not depend on integrator and step; made once for a basis.
struct FloatingBasis {
  std::shared_ptr<const Scene> scene;
  size_t place;  // of the body in the scene
  FloatingBody body;
  BodyState start;
  Regression geometry;                          // of the elastic modes by polynomials: what the contact sees of them,
                                                // of a body that another one meets near that; of none for bodies of
                                                // beam and plate theory
  ShapeBounds bounds;                           // of these polynomials; their values there of the mesh, too
  Matrix3Xd points;                             // [m] evaluation points, body frame
  MatrixXd displacement, strain;                // of elastic modes at the points: 3 p x r, 6 p x r
  MatrixXd static_displacement, static_strain;  // of static shapes
  MatrixXd load_displacement, load_strain;      // of what the modes leave out of loads' patterns; or 0 columns
  std::shared_ptr<const FullModel> full;
  MatrixXd Phi;  // n x r, of the mesh
};
using FloatingBases = std::vector<FloatingBasis>;  // of all bodies, in the scene's order

constexpr double finest_sample = 0.5;  // [-] of the contact's radius

// modes: of each body. corrected: with the static shapes of each contact, pressures on discs about the first touch
// (contact_shapes.h), or with the static response to loads. finest [-] > 0: size of samples where bodies touch first,
// of the contact's radius.
FloatingBases floating_bases(const Model& model, std::span<const Modes> modes, bool corrected,
                             double finest = finest_sample);

bool turn_freely(const Scene& scene);  // free bodies of finite kinematics alone, without contact

}  // namespace mb
