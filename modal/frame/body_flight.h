// A floating body away from all obstacles, in closed form for any time: no steps.
//
//   c = c0 + v0 t + g t^2/2,   torque-free rotation (mechanics/rigid/torque_free.h),   free damped vibration of each
//   mode
//
// With coupling of rotation and modes c alone has a closed form; the rest, with loads all, goes in steps to a tolerance
// (coupled_flow.h).
#pragma once

#include <optional>

#include "mechanics/rigid/torque_free.h"
#include "modal/frame/coupled_flow.h"

namespace mb {

class BodyFlight {
 public:
  BodyFlight(const FloatingBody& body, const BodyState& start, double t0);  // t0 [s]; the body must outlive this
  BodyState at(double t) const;                                             // t [s] >= t0
  double start() const { return t0_; }
  // With coupling or loads, else none and never: steps taken so far; whether they came to an end before a time that was
  // asked for.
  long n_steps() const { return coupled_ ? coupled_->n_steps() : 0; }
  bool failed() const { return coupled_ && coupled_->failed(); }

 private:
  const FloatingBody& body_;
  BodyState start_;
  double t0_;
  Eigen::Quaterniond axes_;  // principal ones
  std::optional<TorqueFree> rotation_;
  std::optional<CoupledFlight> coupled_;
};

}  // namespace mb
