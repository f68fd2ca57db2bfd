// A scene with contact, changed in what its mesh and modes do not depend on, answered again: one eigenproblem serves
// all variants.
#pragma once

#include "harness/analysis/modal_body.h"
#include "modal/contact/floating_answer.h"

namespace mb {

struct ContactContender {
  std::string method;                        // "static-correction", "eigenmodes", "linear", "quadratic", "full-order"
  int modes;                                 // elastic ones, of polynomials 0: all there are; -1: full order
  double time_step = 0;                      // [s] in contact, of modes
  double finest_sample = mb::finest_sample;  // [-] of the contact's radius, of modes
  std::string integrator = "exact";          // of modes, in contact
};

Scene linearised(const Scene& scene);  // of linear kinematics, every body

// Without gravity, the first body thrown so that it meets what it meets in the scene after `flight` [s], at `factor`
// times the velocity that it has there, and watched until `after` [s] past that. The layer stays the scene's own.
// Throws std::invalid_argument for a first body that is held, spins or never meets, and where another one moves: it may
// be held, or rest where nothing pulls it.
Scene thrown(const Scene& scene, double factor, double flight, double after);

class ContactVariants {
 public:
  explicit ContactVariants(const AnalysisContext& context);

  // static-correction with the most modes and the least step of the study, eigenmodes likewise, and full order on their
  // mesh at the truth's tolerance.
  std::vector<ContactContender> contenders() const;
  Scene with_stiffness(std::size_t contact, double stiffness) const;  // [Pa/m], of law hertz [N/m^1.5]
  // As thrown, at the scene's own speed, of one body alone.
  Scene with_flight(double flight, double after) const;

  // The modes and static shapes of a contender in the contact of full order (basis_model.h): small rotations and points
  // on the surface of the mesh in the place of a floating frame and points on the shape. Static shapes have that part
  // of their mass [-], > 0. At a hundredth of the truth's tolerance. Throws as prepare_impact for a body that spins.
  std::unique_ptr<Prepared> prepare_on_mesh(const ContactContender& contender, double mass_of_shapes) const;

  // Of a contender with modes.
  std::shared_ptr<const FloatingBases> bases(const Scene& scene, const ContactContender& contender) const;
  std::unique_ptr<Prepared> prepare(const Scene& scene, const ContactContender& contender) const;
  Trajectory simulate(const Scene& scene, const ContactContender& contender) const;  // at its sample times
  // Likewise by steps twice as long, or at ten times the tolerance: what moves is, where errors fall with the step by
  // order one and more, as much as its steps leave it off by, and more.
  Trajectory simulate_coarsely(const Scene& scene, const ContactContender& contender) const;
  const ModalBody& body() const { return body_; }                           // the first
  const Modes& modes(std::size_t place) const { return modes_.at(place); }  // of any body

 private:
  const AnalysisContext& context_;
  int n_modes_;
  ModalBody body_;
  std::vector<Modes> modes_;  // of every body
};

}  // namespace mb
