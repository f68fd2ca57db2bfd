#include "harness/analysis/beyond_linear.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "mechanics/system/stored_energy.h"

namespace mb {

namespace {

// [-] e, times the largest displacement over the extent: f2 to 1e-7, c3 to 1e-4 of itself
constexpr double small = 1e-3;

VectorXd force(const StoredEnergy& energy, const VectorXd& u) {
  VectorXd f(u.size());
  if (!energy.force(u, VectorXd::Zero(u.size()), f))
    throw std::runtime_error("linearity: a deformation of a thousandth of the body inverts");
  return f;
}

}  // namespace

BeyondLinear beyond_linear(const System& system, const ShiftedFactor& shifted, const VectorXd& u, double extent) {
  if (!system.stored_energy || system.R.cols() > 0)
    throw std::invalid_argument("linearity is told of bodies of kinematics 'finite' that supports hold");
  const double largest = u.size() == system.K.rows() ? u.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() : 0;
  if (!(largest > 0 && std::isfinite(largest)))
    throw std::invalid_argument(fmt::format("linearity: {} displacements of at most {} m", u.size(), largest));
  const StoredEnergy& energy = *system.stored_energy;
  const double e = small * extent / largest;
  const VectorXd f2 = (force(energy, e * u) + force(energy, -e * u)) / (2 * e * e);
  const VectorXd v2 = inertia_relief(system, shifted, -f2);
  const VectorXd odd = (force(energy, e * u + e * e * v2) - force(energy, -e * u + e * e * v2)) / 2;
  const VectorXd c3 = (odd - e * (system.K * u)) / (e * e * e);
  return {v2, inertia_relief(system, shifted, -c3)};
}

}  // namespace mb
