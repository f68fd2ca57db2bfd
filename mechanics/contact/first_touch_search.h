// What both ways to a first touch do with a search.
#pragma once

#include "mechanics/contact/first_touch.h"

namespace mb {

void require_valid(const TouchSearch& search);  // else std::invalid_argument

// The tolerance [m] that counts for coordinates of a size [m]: at least 512 of their roundings.
double touch_tolerance(const TouchSearch& search, double coordinates);

}  // namespace mb
