// Whether steps in contact are still those of bodies: finite, and of no more energy than there was, of all together.
//
//   T + V + stored + dissipated <= that at the touch + T + U at the touch + the weight's work over the body's size
//
// Contact and damping only take energy, and gravity's is part of V: what exceeds this no error of a stable scheme
// gives. A scheme past its limit throws the body off, faster at every bounce, all numbers finite.
#pragma once

#include <span>
#include <vector>

#include "mechanics/system/system.h"
#include "modal/contact/contact_step.h"

namespace mb {

class Soundness {
 public:
  // sizes [m] of the bodies, which must outlive this
  Soundness(std::vector<const FloatingBody*> bodies, const std::vector<double>& sizes);
  void begin(std::span<const ContactState> touching);
  // ok, not_finite or unstable
  Status operator()(std::span<const ContactState> now) const;

 private:
  double total(std::span<const ContactState> now) const;  // [J]

  std::vector<const FloatingBody*> bodies_;
  double weight_ = 0;  // [J] work of the weights over the sizes
  double most_ = 0;
};

}  // namespace mb
