// When a floating body in flight next touches an obstacle: its exact surface, carried by the polynomials of its modes,
// against the obstacle's (mechanics/contact/first_touch.h).
#pragma once

#include <optional>

#include "modal/contact/impact_motion.h"
#include "modal/frame/body_flight.h"

namespace mb {

struct NextTouch {
  double t;      // [s]
  bool decided;  // false: the body skims along the obstacle so closely that nothing could be proved from t on
};

// The earliest in [flight.start(), end]; nothing where there is none. leaving: it has just let go, and what touches but
// parts does not count. Throws std::invalid_argument where state or gravity are not finite.
std::optional<NextTouch> next_touch(const ImpactPlan& plan, const BodyFlight& flight, double end, bool leaving);

}  // namespace mb
