// A scene with contact, changed in what its mesh and modes do not depend on, answered again: one eigenproblem serves
// all variants.
#pragma once

#include "harness/analysis/modal_body.h"
#include "modal/contact/floating_answer.h"

namespace mb {

struct ContactContender {
  std::string method;                        // "static-correction", "eigenmodes" or "full-order"
  int modes;                                 // elastic ones; -1: full order
  double time_step = 0;                      // [s] in contact, of modes
  double finest_sample = mb::finest_sample;  // [-] of the contact's radius, of modes
};

// Of the first contact of an answer, as the truth has it.
struct Impact {
  double start, duration, peak, impulse;  // [s], [s], [N], [N s]; NaN where it has none
};
Impact impact_of(const Trajectory& answer, const Trajectory& truth);

class ContactVariants {
 public:
  explicit ContactVariants(const AnalysisContext& context);

  // static-correction with the most modes and the least step of the study, eigenmodes likewise, and full order on their
  // mesh at the truth's tolerance.
  std::vector<ContactContender> contenders() const;
  Scene with_stiffness(std::size_t contact, double stiffness) const;  // [Pa/m], of law hertz [N/m^1.5]
  // Without gravity, the first body thrown so that it meets its obstacle after `flight` [s] at the speed it has there
  // in the scene, and watched until `after` [s] past that. Throws std::invalid_argument for one that spins or never
  // meets.
  Scene with_flight(double flight, double after) const;

  // Of a contender with modes.
  std::shared_ptr<const FloatingBases> bases(const Scene& scene, const ContactContender& contender) const;
  std::unique_ptr<Prepared> prepare(const Scene& scene, const ContactContender& contender) const;
  Trajectory simulate(const Scene& scene, const ContactContender& contender) const;  // at its sample times

 private:
  const AnalysisContext& context_;
  int n_modes_;
  ModalBody body_;
  std::vector<Modes> modes_;  // of every body
};

}  // namespace mb
