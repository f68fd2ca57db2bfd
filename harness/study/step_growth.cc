#include "harness/study/step_growth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/system/stepped_modes.h"
#include "modal/bases/mesh_radius.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double radius(const System& system, const std::string& integrator, double h) {
  if (!is_in_modes(system)) return mesh_radius(system, integrator, h);
  const Scheme* scheme = scheme_of(integrator, system);
  return scheme ? step_radius(stepped_modes(system), *scheme, h) : nan;
}

// A mesh of which ARPACK finds no mode keeps its answer, and a word that nothing is known of it.
double radius_or_nothing(const System& system, const std::string& integrator, double h) try {
  return radius(system, integrator, h);
} catch (const std::runtime_error&) {
  return nan;
}

// Their energy tells (harness/metrics/contact_metrics.h).
bool is_in_frames(const Reduction& reduction) { return reduction.in_contact && reduction.modes_used >= 0; }

}  // namespace

double predicted_growth(const Reduction& reduction, const std::string& integrator, double h, double duration) {
  if (is_in_frames(reduction)) return nan;
  double largest = 0;
  for (const LinearBody& body : reduction.bodies) {
    const double rho = radius_or_nothing(body.system, integrator, h);
    if (std::isnan(rho)) return nan;
    largest = std::max(largest, std::pow(rho, duration / h));
  }
  return largest;
}

Grown growth_of(const Reduction* reduction, const Integrator& integrator, double h, double duration) {
  if (!reduction || !integrator.conditionally_stable) return {nan, false, false};
  const auto stretches = [](const LinearBody& body) { return body.system.stored_energy != nullptr; };
  const double growth = predicted_growth(*reduction, integrator.name, h, duration);
  return {growth, std::ranges::any_of(reduction->bodies, stretches), std::isnan(growth) && !is_in_frames(*reduction)};
}

}  // namespace mb
