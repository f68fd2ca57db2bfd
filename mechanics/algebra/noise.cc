#include "mechanics/algebra/noise.h"

#include <random>

namespace mb {

VectorXd uniform_noise(Index n, unsigned seed) {
  std::mt19937_64 generator(seed);
  // The standard's distributions differ between libraries; the top 53 bits do not.
  return VectorXd::NullaryExpr(n, [&] { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1; });
}

}  // namespace mb
