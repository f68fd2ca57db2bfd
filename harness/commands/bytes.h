// Sizes for people: powers of 1000, three digits.
#pragma once

#include <string>

namespace mb {

std::string bytes(double n);  // n >= 0: "0 B", "999 B", "1.23 kB", "12.3 MB"

}  // namespace mb
