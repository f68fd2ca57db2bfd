// Whether steps in contact are still those of a body: finite, and of no more energy than there was.
//
//   T + V + stored + dissipated <= that at the touch + T + U at the touch + the weight's work over the body's size
//
// Contact and damping only take energy, and gravity's is part of V: what exceeds this no error of a stable scheme
// gives. A scheme past its limit throws the body off, faster at every bounce, all numbers finite.
#pragma once

#include "mechanics/system/system.h"
#include "modal/contact/contact_step.h"

namespace mb {

class Soundness {
 public:
  Soundness(const FloatingBody& body, double size);  // size [m] of the body; which must outlive this
  void begin(const ContactState& touching);
  // ok, not_finite or unstable
  Status operator()(const ContactState& now) const;

 private:
  double total(const ContactState& now) const;  // [J]

  const FloatingBody& body_;
  double weight_;  // [J] work of the weight over the size
  double most_ = 0;
};

}  // namespace mb
