// When a floating body in flight next touches an obstacle: its exact surface, carried by the polynomials of its modes,
// against the obstacle's (mechanics/contact/first_touch.h).
#pragma once

#include <optional>

#include "modal/contact/body_flight.h"
#include "modal/contact/impact_motion.h"

namespace mb {

// The earliest time [s] in [flight.start(), end]; nothing where there is none. leaving: it has just let go, and what
// touches but parts does not count.
std::optional<double> next_touch(const ImpactPlan& plan, const BodyFlight& flight, double end, bool leaving);

}  // namespace mb
