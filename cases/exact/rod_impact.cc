#include "cases/exact/rod_impact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

constexpr double softest = 5;  // [-] k_n L/E: at softer layers the rod does not leave within the second passage

void check(const RodImpact& rod) {
  const auto positive = [](double value, const char* name) {
    if (!(value > 0 && std::isfinite(value)))
      throw std::invalid_argument(fmt::format("rod_impact: {} must be positive and finite, not {}", name, value));
  };
  positive(rod.length, "the length");
  positive(rod.youngs_modulus, "Young's modulus");
  positive(rod.density, "the density");
  positive(rod.speed, "the speed");
  positive(rod.layer_stiffness, "the layer's stiffness");
  if (const double ratio = rod.layer_stiffness * rod.length / rod.youngs_modulus; !(ratio >= softest))
    throw std::invalid_argument(fmt::format("rod_impact: k_n L/E = {} must be at least {}", ratio, softest));
}

// The y > left/2 where (2 - left + 2 y) e^-y = 1, by Newton's method.
double end_of_release(double left) {
  double y = 1.5;
  for (int k = 0; k < 8; ++k) y += (2 - left + 2 * y - std::exp(y)) / (std::exp(y) - 2);
  return y;
}

// int_0^y (-1 + (2 - left + 2 x) e^-x) dx
double release_impulse(double y, double left) {
  return -y - (2 - left) * std::expm1(-y) + 2 * (-std::expm1(-y) - y * std::exp(-y));
}

}  // namespace

RodImpactWaves::RodImpactWaves(const RodImpact& rod) : rod_(rod) {
  check(rod);
  c_ = std::sqrt(rod.youngs_modulus / rod.density);
  kappa_ = rod.layer_stiffness / (rod.density * c_);
  tau_ = 2 * rod.length / c_;
  left_ = std::exp(-kappa_ * tau_);
  const double size = rod.density * c_ * rod.speed;
  contact_ = {tau_ + end_of_release(left_) / kappa_, size * (2 * std::exp(-left_ / 2) - 1), tau_ + left_ / 2 / kappa_,
              0};
  contact_.impulse = impulse(contact_.duration);
}

double RodImpactWaves::pressure(double t) const {
  const double size = rod_.density * c_ * rod_.speed;
  if (t <= 0 || t >= contact_.duration) return 0;
  if (t <= tau_) return -size * std::expm1(-kappa_ * t);
  const double y = kappa_ * (t - tau_);
  return size * std::max(0.0, -1 + (2 - left_ + 2 * y) * std::exp(-y));
}

double RodImpactWaves::impulse(double t) const {
  const double size = rod_.density * c_ * rod_.speed / kappa_, y = kappa_ * std::clamp(t, 0.0, contact_.duration);
  const double Y = kappa_ * tau_;
  if (y <= Y) return size * (y + std::expm1(-y));
  return size * (Y + std::expm1(-Y) + release_impulse(y - Y, left_));
}

double RodImpactWaves::sum_of_pressures(double t) const {
  double sum = 0;
  for (double m = std::max(0.0, std::ceil((t - contact_.duration) / tau_)); m * tau_ <= t; ++m)
    sum += pressure(t - m * tau_);
  return sum;
}

double RodImpactWaves::sum_of_impulses(double t) const {
  const double n_whole = std::max(0.0, std::ceil((t - contact_.duration) / tau_));
  double sum = n_whole * contact_.impulse;
  for (double m = n_whole; m * tau_ <= t; ++m) sum += impulse(t - m * tau_);
  return sum;
}

RodImpactState RodImpactWaves::state(double z, double t) const {
  const double up = t - z / c_, down = t + z / c_ - tau_, impedance = rod_.density * c_;
  return {-rod_.speed * t + (sum_of_impulses(up) + sum_of_impulses(down)) / impedance,
          (sum_of_pressures(down) - sum_of_pressures(up)) / (impedance * c_)};
}

}  // namespace mb
