#include "harness/metrics/shutter.h"

#include <cmath>
#include <stdexcept>

namespace mb {

std::string to_string(const Shutter& shutter) {
  if (shutter.n_samples == 0) return "exact mean";
  return shutter.n_samples == 1 ? "point" : "box of " + std::to_string(shutter.n_samples);
}

double gain(const Shutter& shutter, double f) {
  if (shutter.n_samples < 0 || !(shutter.width > 0)) throw std::invalid_argument("a shutter of no samples or no width");
  const double y = pi * f * shutter.width;
  if (shutter.n_samples == 0) return y == 0 ? 1 : std::sin(y) / y;
  const double n = shutter.n_samples, between = y / n;
  const double turns = std::round(between / pi);  // near whole turns both sines vanish: their limit, with its sign
  const double rest = between - pi * turns;
  const double sign = std::fmod((n - 1) * std::abs(turns), 2) == 0 ? 1 : -1;
  return sign * (std::abs(rest) < 1e-9 ? 1 : std::sin(n * rest) / (n * std::sin(rest)));
}

double apparent_frequency(double f, double frame_rate) { return std::abs(f - frame_rate * std::round(f / frame_rate)); }

VectorXd whole_frames(double frame_rate, double duration) {
  if (!(frame_rate > 0)) throw std::invalid_argument("the frame rate must be positive");
  const double last = std::floor(duration * frame_rate * (1 + 1e-12) - 0.5);
  const Index n = std::max<Index>(0, static_cast<Index>(last));
  return VectorXd::LinSpaced(n, 1 / frame_rate, static_cast<double>(n) / frame_rate);
}

}  // namespace mb
