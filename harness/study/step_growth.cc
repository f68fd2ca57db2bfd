#include "harness/study/step_growth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/system/stepped_modes.h"
#include "modal/bases/highest_mode.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double uncoupled = 1e-6;  // [-] of omega: damping by single modes and dashpots that the highest mode feels

// Single modes that are damped less than the stiffness would (d < 0), of M phi = w: explicit Euler's limit is theirs.
double radius_of_single_modes(const System& system, const Scheme& scheme, double h) {
  const auto& [W, d] = system.modal_damping;
  if ((d.array() >= 0).all()) return 0;
  const Cholesky mass(system.M);
  double largest = 0;
  for (Index j = 0; j < d.size(); ++j) {
    if (d(j) >= 0) continue;
    VectorXd phi = mass.solve(VectorXd(W.col(j)));
    phi /= std::sqrt(phi.dot(system.M * phi));
    const double omega = std::sqrt(phi.dot(system.K * phi));
    const double zeta = std::max(0., phi.dot(apply_damping(system, phi)) / (2 * omega));
    largest = std::max(largest, spectral_radius(scheme.amplification(omega * h, zeta)));
  }
  return largest;
}

double mesh_radius(const System& system, const Scheme& scheme, double h) {
  const System seen = system.lumped_mass.rows() > 0 ? with_lumped_mass(system) : system;
  const SteppedMode top = highest_mode(seen);
  const auto& [W, d] = system.modal_damping;
  if (d.size() > 0) {
    const VectorXd felt = W * d.cwiseProduct(W.transpose() * top.phi);
    if (!(felt.norm() <= uncoupled * top.omega * top.M_phi.norm())) return nan;
  }
  return std::max(spectral_radius(scheme.amplification(top.omega * h, top.zeta)),
                  radius_of_single_modes(seen, scheme, h));
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
