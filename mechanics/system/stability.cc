#include "mechanics/system/stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/system/system.h"

namespace mb {

namespace {

// Of the conditions above, those terms that may cancel are compared with their sizes.
bool is_stable(const Matrix2d& B, double allowance) {
  const double a = B(0, 0) * B(1, 1), b = B(0, 1) * B(1, 0), trace = B.trace(), determinant = a - b;
  const double sizes = std::abs(B(0, 0)) + std::abs(B(1, 1)) + std::abs(a) + std::abs(b);
  return trace + determinant <= allowance * sizes && determinant >= -allowance * (std::abs(a) + std::abs(b)) &&
         4 + 2 * trace + determinant >= -allowance * (4 + 2 * sizes);
}

double first_crossing(const Scheme& scheme, double zeta, double allowance) {
  constexpr double smallest = 1e-9, largest = 1e6, ratio = 1.02;  // of omega h; the schemes have no thinner islands
  const auto stable = [&](double x) { return is_stable(scheme.increment(x, zeta), allowance); };
  double low = smallest, high = smallest;
  if (!stable(low)) return 0;
  for (; stable(high); low = high, high *= ratio)
    if (high > largest) return std::numeric_limits<double>::infinity();
  while (high - low > 1e-9 * low) {
    const double middle = (low + high) / 2;
    (stable(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

const Scheme& scheme(const std::string& name) {
  for (const Scheme& s : schemes())
    if (s.name == name) return s;
  throw std::out_of_range("no scheme of the name '" + name + "'");
}

bool steps_as(const Scheme& scheme, const System& system) {
  if (scheme.integrator.empty()) return false;
  if (scheme.integrator != "central-difference" || !is_damped(system)) return true;
  const bool lumped = system.lumped_mass.rows() > 0, by_mass = system.damping.alpha != 0;
  const bool coupling =
      system.damping.beta != 0 || (system.modal_damping.d.array() != 0).any() || system.viscous.nonZeros() > 0;
  if (scheme.name == "central-difference") return !lumped || !coupling;
  return lumped && !by_mass;
}

const Scheme* scheme_of(const std::string& integrator, const System& system) {
  for (const Scheme& one : schemes())
    if (one.integrator == integrator && steps_as(one, system)) return &one;
  return nullptr;
}

double spectral_radius(const Matrix2d& A) {
  const double half_trace = A.trace() / 2, half_difference = (A(0, 0) - A(1, 1)) / 2;
  const double discriminant = half_difference * half_difference + A(0, 1) * A(1, 0);
  if (discriminant < 0) return std::sqrt(A.determinant());
  return std::abs(half_trace) + std::sqrt(discriminant);
}

double stable_omega_h(const Scheme& scheme, double zeta) {
  if (!(zeta >= 0 && std::isfinite(zeta)))
    throw std::invalid_argument(fmt::format("stable_omega_h: the damping ratio is {}, must be >= 0", zeta));
  // Growth of a higher order in h than the terms it is the difference of, as of undamped RK2 (1 + (omega h)^4/8), stays
  // within the allowance at small h. A limit that moves with the allowance is none: every step is unstable.
  const double limit = first_crossing(scheme, zeta, 1e-12), stricter = first_crossing(scheme, zeta, 1e-14);
  return stricter < 0.5 * limit ? 0 : limit;
}

}  // namespace mb
