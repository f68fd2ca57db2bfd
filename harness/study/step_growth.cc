#include "harness/study/step_growth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/system/stepped_modes.h"
#include "modal/bases/highest_mode.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double uncoupled = 1e-6;  // [-] of omega: damping by single modes and dashpots that the highest mode feels

double mesh_radius(const System& system, const Scheme& scheme, double h) {
  const SteppedMode top = highest_mode(system.lumped_mass.rows() > 0 ? with_lumped_mass(system) : system);
  const auto& [W, d] = system.modal_damping;
  if (d.size() > 0) {
    const VectorXd felt = W * d.cwiseProduct(W.transpose() * top.phi);
    if (!(felt.norm() <= uncoupled * top.omega * top.M_phi.norm())) return nan;
  }
  return spectral_radius(scheme.amplification(top.omega * h, top.zeta));
}

double radius(const System& system, const std::string& integrator, double h) {
  const bool lags = system.stored_energy && integrator == "central-difference";  // with all of its damping
  const Scheme* scheme = lags ? &mb::scheme("central-difference, lagged damping") : scheme_of(integrator, system);
  if (!scheme) return nan;
  return is_in_modes(system) ? step_radius(stepped_modes(system), *scheme, h) : mesh_radius(system, *scheme, h);
}

}  // namespace

double predicted_growth(const Reduction& reduction, const std::string& integrator, double h, double duration) {
  const bool in_frames = reduction.in_contact && reduction.modes_used >= 0;
  if (in_frames) return nan;
  double largest = 0;
  for (const LinearBody& body : reduction.bodies) {
    const double rho = radius(body.system, integrator, h);
    if (std::isnan(rho)) return nan;
    largest = std::max(largest, std::pow(rho, duration / h));
  }
  return largest;
}

Grown growth_of(const Reduction* reduction, const Integrator& integrator, double h, double duration) {
  if (!reduction || !integrator.conditionally_stable) return {nan, false};
  const auto stretches = [](const LinearBody& body) { return body.system.stored_energy != nullptr; };
  return {predicted_growth(*reduction, integrator.name, h, duration),
          std::ranges::any_of(reduction->bodies, stretches)};
}

}  // namespace mb
