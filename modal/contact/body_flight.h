// A floating body away from all obstacles, in closed form for any time: no steps.
//
//   c = c0 + v0 t + g t^2/2,   torque-free rotation (mechanics/rigid/torque_free.h),   free damped vibration of each
//   mode
#pragma once

#include <optional>

#include "mechanics/rigid/torque_free.h"
#include "modal/contact/floating_body.h"

namespace mb {

class BodyFlight {
 public:
  BodyFlight(const FloatingBody& body, const BodyState& start, double t0);  // t0 [s]; the body must outlive this
  BodyState at(double t) const;                                             // t [s] >= t0
  double start() const { return t0_; }

 private:
  const FloatingBody& body_;
  BodyState start_;
  double t0_;
  Eigen::Quaterniond axes_;  // principal ones
  std::optional<TorqueFree> rotation_;
};

}  // namespace mb
