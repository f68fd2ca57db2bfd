// Whether long double holds more than double does. By valgrind it does not: there it has a double's 53 bits and range.
#pragma once

namespace mb {

inline bool is_long_double_wider() {
  volatile long double one = 1;  // asked where the program runs, not where it is compiled
  const long double sum = one + 0x1p-60L;
  return sum != one;
}

}  // namespace mb
